#!/usr/bin/env python3
"""Changes one word of a program at a time: where neither motions nor diagnostics change, the word was ignored silently.

  ignored_words.py --isogloss PATH [--programs 40] [--words 12] [--seed S] [--dialects fanuc,iso,…] [--list]

A word gets other values, and is then removed. It is a finding when none of these changes shows in the blocks, the
motions or the diagnostics, unless its line is not run at all or a diagnostic names the word. Codes are left out: many
name what is in force anyway. A finding either stands in inert_words.txt, by program and address, with the reason why
nothing changes, or it is a fault.
"""
import argparse
import collections
import pathlib
import random
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import budgeted  # noqa: E402: it lies in another folder
from golden_programs import PROGRAMS, dialect_of, golden_files  # noqa: E402
from random_bytes import BUDGETS, SUFFIXES  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
TIMEOUT = 60
NUMBER = r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)"
WORD = re.compile(rf"(?<![A-Za-z0-9_#\[.])([A-Za-z])\s?=?({NUMBER})(?![0-9A-Za-z.=\[])")


def inert():
    """By program and address: the reason."""
    out = {}
    for line in (HERE / "inert_words.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            program, addresses, reason = line.split(None, 2)
            for address in addresses.split(","):
                out[program, address] = reason
    return out


def without_comments(line, dialect):
    """Blanks in place of what no control reads."""
    blank = lambda m: " " * len(m[0])  # noqa: E731: it is short
    line = re.sub(r'"[^"]*"', blank, line)
    if dialect not in ("siemens", "heidenhain"):
        line = re.sub(r"\([^)]*\)?", blank, line)
    return re.sub(r";.*|^\s*N?[0-9]+(?=\s|[A-Z])|^\s*[/%].*|//.*", blank, line)


def changes(letter, number):
    """The replacements of the word: other values, and nothing."""
    value = float(number)
    others = [value + 1, -value if value else 7, value * 2 + 0.5]
    return [f"{letter}{v:.3f}" for v in others] + [""]


class Program:
    def __init__(self, isogloss, dialect, path, folder):
        self.isogloss, self.dialect = isogloss, dialect
        self.lines = path.read_text(errors="replace").splitlines()
        arguments = path.with_suffix(".args")
        self.arguments = arguments.read_text().split() if arguments.exists() else []
        self.where, self.folder = path.parent, folder

    def outcome(self, lines):
        """Blocks, motions and diagnostics, as text. It lies in its own folder, beside what it calls."""
        text = "\n".join(lines) + "\n"
        file = self.folder / "part.nc"
        file.write_text(text)
        out = []
        for emit in ("blocks", "motions"):
            done = subprocess.run([self.isogloss, "run", file, "-d", self.dialect, "--emit", emit, "--repeats", "0",
                                   "--subprograms", ".", *BUDGETS, *self.arguments], capture_output=True,
                                  timeout=TIMEOUT, check=False, cwd=self.where)
            # A block shows its text, which changes in any case.
            out.append(re.sub(rb'"(UnparsedText|Comment|Text)":"(\\.|[^"\\])*",?', b"", done.stdout))
            out.append(re.sub(rb"(:\d+):\d+: ", rb"\1: ", done.stderr))
        return out

    def words(self):
        for number, line in enumerate(self.lines):
            for m in WORD.finditer(without_comments(line, self.dialect)):
                if m[1] not in "GgMmNO":
                    yield number, m

    def is_run(self, before, number):
        lines = list(self.lines)
        lines[number] = "G199 ?"
        return self.outcome(lines) != before

    def is_ignored(self, before, number, m):
        line = self.lines[number]
        if f"part.nc:{number + 1}:".encode() in before[1] + before[3]:
            return False
        for new in changes(m[1], m[2]):
            lines = list(self.lines)
            lines[number] = line[:m.start()] + new + line[m.end():]
            if self.outcome(lines) != before:
                return False
        return self.is_run(before, number)


def choice(seed, path):
    """The random numbers of one program: a further program in the tree changes none of the others."""
    return random.Random(f"{seed} {path.relative_to(PROGRAMS)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--programs", type=int, default=budgeted(24))
    parser.add_argument("--words", type=int, default=12)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--dialects", default="")
    parser.add_argument("--list", action="store_true", help="those with a reason, too")
    options = parser.parse_args()
    isogloss = options.isogloss.resolve()
    known = inert()
    wanted = options.dialects.split(",") if options.dialects else None
    programs = [p for p in golden_files() if p.suffix in SUFFIXES and p.stat().st_size < 6000
                and (wanted is None or dialect_of(p) in wanted)]
    programs.sort(key=lambda p: choice(options.seed, p).random())
    found, tried = collections.defaultdict(list), 0
    with tempfile.TemporaryDirectory(prefix="isogloss-words-") as name:
        for path in programs[:options.programs]:
            program = Program(isogloss, dialect_of(path), path, pathlib.Path(name))
            before = program.outcome(program.lines)
            if any(code in before[1] for code in (b"ISO-0540", b"ISO-0541")):
                continue  # the text is refused as a whole
            words = list(program.words())
            for number, m in choice(options.seed, path).sample(words, min(options.words, len(words))):
                tried += 1
                kind = (str(path.relative_to(PROGRAMS)), m[1].upper())
                if not program.is_ignored(before, number, m):
                    continue
                if options.list or kind not in known:
                    found[kind].append(f"line {number + 1}: {m[0]} in {program.lines[number].strip()}")
    for (program, word), places in sorted(found.items()):
        print(f"{program} {word}: {len(places)} ignored in silence, {places[0]}")
    print(f"{tried} words, {len(found)} ignored without a reason")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
