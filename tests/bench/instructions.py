#!/usr/bin/env python3
"""Counts the instructions of a block of each workload, of a start, and what idle syntaxes add: times are noisy, counts
are not.

  instructions.py --isogloss FILE --tools DIR --idle DIR [--compiler NAME] [--write]

Fails where a block takes over 3 % more instructions than instructions.json says, or a start over 5 %, which also loads
the system's libraries; or where idle syntaxes cost more than their limits. --write writes instructions.json. The counts
hold for one compiler: for another, only the idle syntaxes are judged.
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import surface_forms

HERE = pathlib.Path(__file__).resolve().parent
RECORD = HERE / "instructions.json"
LOSS = {"block": 0.03, "start": 0.05}
FEW, MANY = 2001, 12001  # lines; what they share is the start
IDLE = {50: 0.05, 500: 0.20}
FORMATS = {"none": ["--emit", "none"],
           "csv": ["--emit", "motions", "--format", "csv", "-o", "/dev/null"],
           "jsonl": ["--emit", "motions", "--format", "jsonl", "-o", "/dev/null"]}
LANGUAGES = {"siemens": ("mpf", surface_forms.siemens), "heidenhain": ("h", surface_forms.klartext)}
CASES = [("surface", "none"), ("surface", "csv"), ("surface", "jsonl"), ("mixed", "none"), ("mixed", "csv"),
         ("drilling", "none"), ("drilling", "csv"), ("five-axis", "none")]


def without_debug_information(isogloss, folder):
    """A copy of the command and its plugins: valgrind reads all debug information at each start, half of its time here."""
    if shutil.which("strip") is None:
        return isogloss
    (folder / "plugins").mkdir(parents=True)
    for name in ("isogloss", *(f"plugins/{p.name}" for p in (isogloss.parent / "plugins").glob("*.so"))):
        subprocess.run(["strip", "-o", folder / name, isogloss.parent / name], check=True)
    for name in ("dialects", "schemas"):
        (folder / name).symlink_to((isogloss.parent / name).resolve())
    return folder / "isogloss"


class Counter:
    def __init__(self, options, folder):
        self.options = options
        self.folder = folder
        self.isogloss = without_debug_information(options.isogloss.resolve(), folder / "stripped")
        rows = "".join(f'  <Tool id="{t}" H="{100 + 2.5 * t}"/>\n' for t in range(1, 21))
        self.tools = folder / "tools.xml"
        self.tools.write_text(f"<ToolOffsetTable>\n{rows}</ToolOffsetTable>\n")
        self.environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")}

    def program(self, kind, lines):
        path = self.folder / f"{kind}-{lines}.nc"
        if not path.exists():
            subprocess.run([self.options.tools / "workload", kind, str(lines), "-o", path], check=True)
        return path

    def program_in(self, dialect, kind, lines):
        program = self.program(kind, lines)
        if dialect not in LANGUAGES:
            return program
        suffix, form = LANGUAGES[dialect]
        path = program.with_suffix(f".{suffix}")
        path.write_text(form(program.read_text()))
        return path

    def count(self, kind, lines, arguments, dialect):
        command = ["valgrind", "--tool=cachegrind", "--cache-sim=no", f"--cachegrind-out-file={self.folder}/counts",
                   self.isogloss, "run", self.program_in(dialect, kind, lines), "-d", dialect, "--watchdog", "0",
                   "--scan-ahead", "0", *arguments]
        command += ["--machine", HERE / "five_axis.xml"] if kind == "five-axis" else ["--tools", self.tools]
        done = subprocess.run([str(part) for part in command], capture_output=True, text=True, env=self.environment)
        found = re.search(r"I +refs: +([\d,]+)", done.stderr)
        if done.returncode != 0 or not found:
            sys.exit(f"exit status {done.returncode}: {command}\n{done.stderr[-2000:]}")
        return int(found[1].replace(",", ""))

    def block_and_start(self, kind, arguments, dialect="fanuc"):
        """Instructions of a block, and of what comes before the first one and after the last."""
        few, many = (self.count(kind, lines, arguments, dialect) for lines in (FEW, MANY))
        block = (many - few) / (MANY - FEW)
        return block, few - FEW * block

    def with_idle(self, number):
        dialect = self.folder / f"idle-{number}.xml"
        elements = "".join(f'<IdleSyntax as="idle{i}"/>' for i in range(number))
        dialect.write_text(f'<Dialect xmlns="urn:isogloss:dialect:1" name="idle-{number}" extends="fanuc">\n'
                           f'<Plugins><Plugin name="idle"/></Plugins>\n<Chain><InsertBefore syntax="McXyzSyntax">'
                           f"{elements}</InsertBefore></Chain>\n</Dialect>\n")
        return self.block_and_start("surface", [*FORMATS["none"], "--plugins", self.options.idle], dialect)[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", type=pathlib.Path, required=True)
    parser.add_argument("--tools", type=pathlib.Path, required=True, help="the folder of the program workload")
    parser.add_argument("--idle", type=pathlib.Path, required=True, help="the folder of the plugin idle")
    parser.add_argument("--compiler", default="", help="name and version, as CMake gives them")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        counter = Counter(options, pathlib.Path(folder))
        counts, starts = {}, {}
        for kind, form in CASES:
            counts[f"{kind} {form}"], start = counter.block_and_start(kind, FORMATS[form])
            starts.setdefault("start fanuc", start)
        for dialect in LANGUAGES:
            counts[f"surface {dialect} none"], starts[f"start {dialect}"] = counter.block_and_start(
                "surface", FORMATS["none"], dialect)
        counts |= starts
        if options.write:
            RECORD.write_text(json.dumps({"Compiler": options.compiler, "Instructions": {
                case: round(count) for case, count in counts.items()}}, indent=2) + "\n")
        record = json.loads(RECORD.read_text())
        is_same = record["Compiler"] == options.compiler
        if not is_same:
            print(f"the counts were recorded with {record['Compiler']}, this is {options.compiler}: not compared")
        for case, count in counts.items():
            before = record["Instructions"][case]
            what = "start" if case in starts else "block"
            print(f"{case:24} {count:8.0f} instructions a {what}, recorded {before}: {count / before - 1:+.1%}")
            if is_same and count > before * (1 + LOSS[what]):
                faults.append(f"{case}: a {what} takes {count / before - 1:.1%} more instructions than recorded")
        for number, limit in IDLE.items():
            more = counter.with_idle(number) / counts["surface none"] - 1
            print(f"{number:4} idle syntaxes: {more:+.1%} instructions a block, at most {limit:.0%}")
            if more > limit:
                faults.append(f"{number} idle syntaxes cost {more:.1%}, more than {limit:.0%}")
    for fault in faults:
        print(f"FAILED: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
