"""The tests that can kill a mutant, what each of them reaches, and whether one of them fails with a mutant."""
import concurrent.futures
import dataclasses
import json
import os
import pathlib
import signal
import subprocess
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from golden_programs import PROGRAMS, golden_files  # noqa: E402: it lies in another folder
from instrument import digest, stem_of, tracked  # noqa: E402

MODELS = ("cycles/cycles_test", "cycles/syntec_test", "cycles/extremes_test", "five_axis/tip_test", "five_axis/faces_test",
          "five_axis/feed_test", "five_axis/swing_test", "five_axis/dialect_test", "frames/frames_test",
          "frames/program_words_test", "frames/coordinate_shift_test", "tilt/tilt_test", "tilt/cycles_test",
          "klartext/cycles_test", "klartext/frames_test", "klartext/scaling_test", "siemens/cycles_test",
          "siemens/frames_test")
# Of the rooms of programs that reach a mutant, so many of the shortest are tried: the pages have said most by then.
most_rooms = 8
pages_at_once = 16
# Seconds of the processor for one process: a mutant that hangs ends there.
most_seconds = {"page": 8, "unit": 20, "program": 8, "model": 60}
most_memory = 6 << 20  # KiB


@dataclasses.dataclass
class Test:
    """`parts`: the pages or programs of one process. What it reaches is known once it has run without a mutant."""
    kind: str
    name: str
    parts: list
    inputs: list
    seconds: float = 0
    reached: bytes | None = None
    lock: threading.Lock = dataclasses.field(default_factory=threading.Lock)


class Tests:
    def __init__(self, source, instrumented, models=MODELS):
        self.source, self.instrumented = source, instrumented
        self.isogloss = instrumented.home / "isogloss"
        self.python = sys.executable
        self.tests = []
        rooms = {}
        stems = {stem_of(name) for name in instrumented.files}
        for name in tracked(source, "plugins/*.md"):
            # A process for each page of a syntax in scope, and one for all others of a room.
            rooms.setdefault(name if stem_of(name) in stems else str(pathlib.PurePath(name).parent), []).append(name)
        self.tests += [Test("page", room, pages, [source / name for name in pages]) for room, pages in rooms.items()]
        self.tests += [Test("unit", name, [name], [source / p for p in tracked(source, f"plugins/{name[:-6]}/*_test.cpp")])
                       for name in instrumented.unit_tests()]
        rooms = {}
        for program in golden_files(".nc"):
            rooms.setdefault(program.parent, []).append(str(program.relative_to(PROGRAMS).with_suffix("")))
        for room, programs in rooms.items():
            inputs = sorted(path for path in room.rglob("*") if path.is_file())
            self.tests.append(Test("program", str(room.relative_to(PROGRAMS)), programs, inputs))
        for name in models:
            own = [source / path for path in tracked(source, f"tests/{name.split('/')[0]}/*.py", "tests/support/*.py")]
            self.tests.append(Test("model", name, [name], own))

    def command(self, kind, parts):
        if kind == "page":
            return [self.isogloss, "case", *parts]
        if kind == "unit":
            return [self.instrumented.folder / "build" / "plugins" / parts[0][:-6] / parts[0]]
        if kind == "program":
            return [self.python, "-B", "tests/programs/regenerate.py", "--check", "--once", "--isogloss", self.isogloss, *parts]
        return [self.python, "-B", f"tests/{parts[0]}.py", "--isogloss", self.isogloss]

    def passes(self, kind, parts, **environment):
        limited = ["sh", "-c", f'ulimit -t {most_seconds[kind]} -v {most_memory} -c 0; exec "$@"', "sh"]
        process = subprocess.Popen([*limited, *map(str, self.command(kind, parts))], cwd=self.source, start_new_session=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                   env=os.environ | {k: str(v) for k, v in environment.items()})
        try:
            self.output, _ = process.communicate(timeout=60 * most_seconds[kind])
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
            return False
        return process.returncode == 0

    def baseline(self, jobs, say):
        """Without a mutant every test must hold. Models, which take longest, are asked when the first mutant needs them."""
        self.folder = self.instrumented.folder / "reached"
        self.folder.mkdir(exist_ok=True)
        self.plugins = digest(*sorted((self.instrumented.home / "plugins").glob("*.so")), self.isogloss,
                              *(self.source / name for name in tracked(self.source, "dialects")))
        first = [test for test in self.tests if test.kind != "model"]
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            list(pool.map(self.measure, first))
        say(f"{len(first)} tests hold without a mutant")

    def measure(self, test):
        """What a test reaches is kept until it or the plugins change."""
        with test.lock:
            if test.reached is not None:
                return test
            path = self.folder / (test.kind + "-" + test.name.replace("/", "-"))
            known = path.with_name(path.name + ".json")
            state = digest(self.plugins, *test.inputs)
            entry = json.loads(known.read_text()) if known.exists() and path.exists() else {}
            if entry.get("state") != state:
                known.unlink(missing_ok=True)
                path.write_bytes(bytes(len(self.instrumented.mutants) + 1))
                begin = time.monotonic()
                if not self.passes(test.kind, test.parts, ISOGLOSS_MUTANT=0, ISOGLOSS_MUTANT_REACHED=path):
                    raise RuntimeError(f"without a mutant this fails: {test.kind} {test.name}")
                entry = {"state": state, "seconds": time.monotonic() - begin}
                known.write_text(json.dumps(entry))
            test.seconds, test.reached = entry["seconds"], path.read_bytes()
            return test

    def killer(self, number, mutant):
        """The test that fails with the mutant, "" where none does, and None where no test reaches the mutant."""
        reached = False
        for group in self.groups(number, mutant):
            reached = True
            parts = [part for test in group for part in test.parts]
            if not self.passes(group[0].kind, parts, ISOGLOSS_MUTANT=number):
                for report in (self.source / "tests" / "programs").rglob("isogloss-crash-*.md"):
                    report.unlink(missing_ok=True)
                return f"{group[0].kind} {group[0].name}" + (" and others" if len(group) > 1 else "")
        return "" if reached else None

    def groups(self, number, mutant):
        """The tests that reach the mutant, as many as one process runs at once: the page of its syntax first, models last."""
        def reaching(kind):
            found = [self.measure(test) for test in self.tests if test.kind == kind]
            return sorted((t for t in found if t.reached[number:number + 1] == b"\1"), key=lambda t: t.seconds)

        own, pages = stem_of(mutant.file), reaching("page")
        first = [t for t in pages if stem_of(t.name) == own] or pages[:2]
        if first:
            yield first
        yield from cut([t for t in pages if t not in first], pages_at_once)
        for test in reaching("unit") + reaching("program")[:most_rooms] + reaching("model"):
            yield [test]


def cut(items, size):
    return [items[i:i + size] for i in range(0, len(items), size)]
