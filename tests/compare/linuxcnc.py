#!/usr/bin/env python3
"""Compares the machine coordinates of `isogloss run` with those of LinuxCNC's rs274, move by move.

  linuxcnc.py --isogloss PATH [--programs N] [--seed S] [--cycles G81,G82] [--keep DIR] [FILE.nc...]

The programs are those beside this script (or FILE), N random ones in the language that both controls share (plain.py),
and as many with macros (macro.py). tests/differences.md lists the known differences: `translated` writes them in
LinuxCNC's way where there is one. Lengths must agree to 1e-4 mm, in inches to half of rs274's last decimal. Exit status
77 where rs274 is not installed.
"""
import argparse
import itertools
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import budgeted  # noqa: E402: it lies in another folder

import canon
import macro
import moves
import plain

HERE = pathlib.Path(__file__).resolve().parent
SKIPPED = 77
# LinuxCNC's clearance in G73 and G83 is a hundredth of an inch; ours stands in parameters 5114 and 5115. Bit 5 of 1403: F of
# a helix is the speed along its path, as there.
PARAMETERS = [a for n, value in ((5114, 254), (5115, 254), (1403, 32))
              for a in ("--set", f"FanucParameterTable.{n}.Value={value}")]


def translated(text):
    """The program for rs274: N is the line, P of a dwell in seconds, L repeats a cycle, Z is the length of a tool."""
    lines = []
    for number, line in enumerate(text.splitlines(), 1):
        line = re.sub(r"^N\d+\s*", "", line)
        if re.search(r"G0?4(?!\d)|G82", line):
            line = re.sub(r"P(\d+)", lambda p: f"P{int(p[1]) / 1000:g}", line)
        if re.search(r"L10(?!\d)", line):
            line = re.sub(r"L10( ?P\d+ ?)R", r"L1\1Z", line)
        if re.search(r"G(73|8\d)", line):
            line = re.sub(r"K(\d+)", r"L\1", line)
        lines.append(line if line.startswith("%") or not line else f"N{number} {line}")
    return "\n".join(lines) + "\n"


class Comparison:
    def __init__(self, isogloss, folder, arguments):
        self.isogloss, self.folder, self.arguments = isogloss, folder, arguments
        (folder / "tool.tbl").write_text("".join(f"T{t} P{t} Z{plain.tool_length(t) / 25.4:.4f} D0.2 ;\n"
                                                 for t in range(1, plain.TOOLS + 1)))
        rows = "".join(f'  <Tool id="{t}" H="{plain.tool_length(t):.4f}"/>\n'
                       for t in range(1, plain.TOOLS + 1))
        (folder / "tools.xml").write_text(f"<ToolOffsetTable>\n{rows}</ToolOffsetTable>\n")

    def theirs(self, text):
        (self.folder / "in.ngc").write_text(text)
        (self.folder / "fresh.var").write_text("")
        (self.folder / "out.canon").unlink(missing_ok=True)
        run = subprocess.run(["rs274", "-t", "tool.tbl", "-v", "fresh.var", "-g", "in.ngc", "out.canon"],
                             cwd=self.folder, capture_output=True, text=True, timeout=60, check=False,
                             env={**os.environ, "HOME": str(self.folder)})  # where rs274 shares its tools with others
        if not (self.folder / "out.canon").exists():
            raise RuntimeError("rs274 writes nothing: " + run.stderr[:400])
        reader = canon.Canon()
        result = list(moves.without_zero_moves(list(reader.read((self.folder / "out.canon").read_text()))))
        if not reader.ended:
            raise RuntimeError("rs274 refuses the program: " + " ".join((run.stdout + run.stderr).split())[:400])
        return result

    def ours(self, text):
        (self.folder / "in.nc").write_text(text)
        run = subprocess.run([self.isogloss, "run", "in.nc", "-d", "fanuc", "--tools", "tools.xml", "--emit", "motions",
                              "--format", "csv", *self.arguments],
                             cwd=self.folder, capture_output=True, text=True, timeout=60, check=False)
        if run.returncode != 0:
            raise RuntimeError(f"isogloss ends with {run.returncode}: {run.stderr[:600]}")
        return list(moves.without_zero_moves(moves.from_csv(run.stdout)))

    def compare(self, text, translation):
        """(moves compared, report of the first difference or None)"""
        try:
            ours, theirs = self.ours(text), self.theirs(translation)
        except RuntimeError as error:
            return 0, str(error)
        source = text.splitlines()
        for count, (a, b) in enumerate(itertools.zip_longest(ours, theirs)):
            what = "a move that the other side has not" if a is None or b is None else moves.difference(a, b)
            if what:
                line = (a or b).line
                return count, (f"{what}\n    program   {source[line - 1] if 0 < line <= len(source) else ''}\n"
                               f"    isogloss  {a or '-'}\n    linuxcnc  {b or '-'}")
        return len(ours), None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--programs", type=int, default=budgeted(40))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--cycles", default=",".join(plain.CYCLES), help="in the random programs")
    parser.add_argument("--keep", type=pathlib.Path, help="write programs that differ there")
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    if not shutil.which("rs274"):
        print("rs274 is not installed (Debian: linuxcnc-uspace)")
        return SKIPPED

    files = options.files or sorted(HERE.glob("*.nc"))
    programs = [(f.name, text, translated(text)) for f in files for text in [f.read_text()]]
    if not options.files:
        numbers = range(options.seed, options.seed + options.programs)
        programs += [(f"seed {s}", text, translated(text))
                     for s in numbers for text in [plain.program(s, options.cycles.split(","))]]
        programs += [(f"macro seed {s}", *macro.program(s)) for s in numbers]
    compared = differing = 0
    with tempfile.TemporaryDirectory(prefix="isogloss-compare-") as name:
        comparison = Comparison(options.isogloss.resolve(), pathlib.Path(name), PARAMETERS)
        for title, text, translation in programs:
            count, report = comparison.compare(text, translation)
            compared += count
            if report:
                differing += 1
                print(f"{title}: after {count} equal moves: {report}")
                if options.keep:
                    options.keep.mkdir(parents=True, exist_ok=True)
                    (options.keep / f"{title.replace(' ', '')}.nc").write_text(text)
                    (options.keep / f"{title.replace(' ', '')}.ngc").write_text(translation)
    print(f"{len(programs)} programs, {compared} moves equal, {differing} programs differ")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
