"""A copy of the tree in which every mutant of the chosen sources stands, and its plugins built from it."""
import dataclasses
import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess

import find_mutants
import schemata

HERE = pathlib.Path(__file__).resolve().parent
ROOMS = ("cycles", "frames", "five_axis", "offsets")
# Rooms that are named after a control hold such syntaxes as well.
FURTHER = ("plugins/fanuc/haas/haas_dynamic_offset_syntax.cpp", "plugins/fanuc/haas/haas_mirror_syntax.cpp",
           "plugins/fanuc/haas/haas_pocket_syntax.cpp", "plugins/fanuc/haas/haas_tool_center_syntax.cpp",
           "plugins/fanuc/okuma/okuma_work_offset_syntax.cpp")


def tracked(source, *patterns):
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z", "--", *patterns], cwd=source, check=True,
                            capture_output=True, text=True).stdout
    return sorted(name for name in listed.split("\0") if name and (source / name).is_file())


def sources_in_scope(source):
    """The sources and headers of the cycle, frame and five-axis syntaxes, by plugin and room."""
    return [name for name in tracked(source, "plugins/*.cpp", "plugins/*.hpp")
            if not name.endswith("_test.cpp") and (name.split("/")[2] in ROOMS or name in FURTHER)]


def stem_of(name):
    """`x_syntax` of `x_syntax.cpp`, `x_syntax.md` and `x_syntax.cases.md`."""
    return pathlib.PurePath(name).name.split(".")[0]


def digest(*parts):
    whole = hashlib.sha256()
    for part in parts:
        data = part.read_bytes() if isinstance(part, pathlib.Path) else str(part).encode()
        whole.update(len(data).to_bytes(8, "little") + data)
    return whole.hexdigest()


class Instrumented:
    """`mutants[number - 1]` has the number by which a process chooses it; `refused`: the numbers that do not compile."""

    def __init__(self, source, release, folder, say):
        self.source, self.release, self.folder, self.say = source, release, folder, say
        self.files = sources_in_scope(source)
        self.mutants, self.left_out, self.refused = [], {}, set()
        self.plugins = sorted({name.split("/")[1] for name in self.files})
        self.home = folder / "home"

    def text(self, name):
        return find_mutants.read_source(self.source / name)

    # Which mutants there are

    def find(self):
        listed = self.folder / "mutants.json"
        headers = [self.source / name for name in tracked(self.source, "host/sdk/*.hpp", "host/abi/*.h")]
        state = digest(*(self.source / name for name in self.files), *headers, HERE / "find_mutants.py")
        if listed.exists():
            known = json.loads(listed.read_text())
            if known["state"] == state:
                self.mutants = [find_mutants.Mutant(**m) for m in known["mutants"]]
                self.left_out, self.refused = known["left_out"], set(known["refused"])
                return
        finder = find_mutants.Finder(self.source, self.files)
        for unit, arguments in self._units():
            finder.read(unit, arguments)
        self.mutants, self.left_out = finder.mutants(), dict(finder.left_out)
        self._keep(state)

    def _keep(self, state):
        (self.folder / "mutants.json").write_text(json.dumps(
            {"state": state, "mutants": [dataclasses.asdict(m) for m in self.mutants], "left_out": self.left_out,
             "refused": sorted(self.refused)}))

    def _units(self):
        """The batches of the release build that hold a source in scope, with what the compiler is told of includes."""
        wanted = {str(self.source / name) for name in self.files}
        for entry in json.loads((self.release / "compile_commands.json").read_text()):
            unit = pathlib.Path(entry["file"])
            if not re.search(r"/plugins/\w+/CMakeFiles/\w+_objects\.dir/", str(unit)) or not unit.is_file():
                continue
            if not wanted.intersection(re.findall(r'#include "([^"]+)"', unit.read_text())):
                continue
            words = shlex.split(entry["command"])
            arguments = [w for w in words if w.startswith(("-I", "-D", "-std"))]
            for i, word in enumerate(words):
                if word == "-isystem":
                    arguments += ["-isystem", words[i + 1]]
            yield str(unit), [*arguments, "-Wno-everything"]

    # The build

    def build(self, jobs):
        """The compiler has the last word on what a mutant may be: those in a line that it complains of are left out."""
        copy, built = self.folder / "source", self.folder / "build"
        for _ in range(6):
            self._write_copy(copy)
            if not (built / "build.ninja").exists():
                self._configure(copy, built)
            targets = [f"{self.folder}/build/plugins/{p}.so" for p in self.plugins] + self.unit_tests()
            done = subprocess.run(["cmake", "--build", built, "-j", str(jobs), "--target", *self.plugins, *self.unit_tests(),
                                   "--", "-k", "0"], capture_output=True, text=True, check=False)
            if done.returncode == 0:
                self._make_home(built, targets)
                return
            refused = self._complained_of(copy, done.stdout + done.stderr)
            if not refused:
                raise RuntimeError(f"the instrumented plugins do not build:\n{(done.stdout + done.stderr)[-4000:]}")
            self.say(f"the compiler refuses {len(refused)} mutants; they are left out")
            self.refused |= refused
            known = json.loads((self.folder / "mutants.json").read_text())
            known["refused"] = sorted(self.refused)
            (self.folder / "mutants.json").write_text(json.dumps(known))
        raise RuntimeError("the instrumented plugins do not build")

    def unit_tests(self):
        return [f"{p}_tests" for p in self.plugins if tracked(self.source, f"plugins/{p}/*_test.cpp")]

    def _configure(self, copy, built):
        launcher = shutil.which("ccache")
        cached = [f"-DCMAKE_{language}_COMPILER_LAUNCHER={launcher}" for language in ("C", "CXX") if launcher]
        subprocess.run(["cmake", "-G", "Ninja", "-S", copy, "-B", built, "-DCMAKE_BUILD_TYPE=Release", "-DISOGLOSS_TESTS=ON",
                        "-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG -D_GLIBCXX_ASSERTIONS", "-DCMAKE_COMPILE_WARNING_AS_ERROR=OFF",
                        f"-DCMAKE_CXX_FLAGS=-w -Wno-narrowing -include {copy}/tests/mutants/mutant.hpp", *cached],
                       check=True, stdout=subprocess.DEVNULL)

    def _write_copy(self, copy):
        by_file = {}
        for number, mutant in enumerate(self.mutants, 1):
            if number not in self.refused:
                by_file.setdefault(mutant.file, []).append((number, mutant))
        # Of the tests, what unit tests of plugins are built with: to configure the others takes longer than their programs.
        wanted = [name for name in tracked(self.source) if not name.startswith("tests/") or
                  name.startswith(("tests/CMakeLists.txt", "tests/macro/expressions.txt", "tests/support/",
                                   "tests/mutants/mutant.hpp"))]
        for name in wanted:
            data = (self.source / name).read_bytes()
            if name in by_file:
                data = schemata.rendered(data.decode("latin-1"), by_file[name]).encode("latin-1")
            target = copy / name
            if not target.exists() or target.read_bytes() != data:
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(data)
        kept = set(wanted)
        for path in copy.rglob("*"):
            if path.is_file() and str(path.relative_to(copy)) not in kept:
                path.unlink()

    def _complained_of(self, copy, output):
        lines = set()
        for found in re.finditer(rf"^{re.escape(str(copy))}/([^:\n]+):(\d+):\d+: +(?:error|required from)", output, re.M):
            lines.add((found[1], int(found[2])))
        refused = set()
        for number, mutant in enumerate(self.mutants, 1):
            text = self.text(mutant.file) if any(mutant.file == name for name, _ in lines) else None
            if text is None or number in self.refused:
                continue
            first, last = text.count("\n", 0, mutant.start) + 1, text.count("\n", 0, mutant.end) + 1
            if any(mutant.file == name and first <= line <= last for name, line in lines):
                refused.add(number)
        return refused

    def _make_home(self, built, targets):
        """The command of the release build, the instrumented plugins and the others; the command finds them beside it."""
        plugins = self.home / "plugins"
        plugins.mkdir(parents=True, exist_ok=True)
        copied = [(self.release / "isogloss", self.home / "isogloss")]
        for path in (self.release / "plugins").glob("*.so"):
            own = built / "plugins" / path.name
            copied.append((own if path.stem in self.plugins else path, plugins / path.name))
        for path, target in copied:
            if not target.exists() or target.read_bytes() != path.read_bytes():
                shutil.copy2(path, target)
        for name, target in (("dialects", "dialects"), ("schemas", "schemas"), ("templates", "host/cli/templates")):
            link = self.home / name
            if not link.exists():
                os.symlink(self.source / target, link)
