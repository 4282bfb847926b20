#!/usr/bin/env python3
"""Runs each program of programs.txt and compares its moves and diagnostics with the expectation beside it.

  programs_test.py --isogloss PATH [--show] [NAME...]

Without a name: all, or as many as ISOGLOSS_TEST_BUDGET allows.

--show prints what the programs do now; nothing is written. An expectation is checked by hand before it is kept.
"""
import argparse
import csv
import io
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import sampled  # noqa: E402: it lies in another folder

TABLE = pathlib.Path(__file__).resolve().parent / "programs.txt"


def programs():
    """(name, dialect, arguments, text, expected)"""
    lines = [line for line in TABLE.read_text().splitlines() if line and not line.startswith("#")]
    for head, text, expected in zip(*[iter(lines)] * 3):
        name, dialect, *arguments = head.split()
        yield name, dialect, arguments, text.strip().replace(" | ", "\n") + "\n", expected.strip().removeprefix(">> ")


def result(isogloss, folder, dialect, arguments, text):
    (folder / "x.nc").write_text(text)
    run = subprocess.run([isogloss, "run", "x.nc", "--repeats", "0", "-d", dialect, "--emit", "motions", "--format", "csv",
                          *arguments],
                         cwd=folder, capture_output=True, text=True, timeout=30, check=False)
    events = []
    for row in csv.DictReader(io.StringIO(run.stdout)):
        if row["event"] in ("rapid", "feed", "arc"):
            events.append(row["event"][0] + ",".join(row[axis] for axis in ("px", "py", "pz")))
        elif row["event"] == "dwell":
            events.append("d" + row["value"])
        elif row["event"] in ("end", "stop"):
            events.append(row["event"][0])
    said = re.findall(r": (?:error|warning): .*\[([A-Z]+-\d+)\]", run.stderr)
    # These programs are a few words long and name no unit: the warning of UnitModeSyntax has golden programs of its own.
    return " ".join(events + [code for code in said if code != "ISO-0373"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--show", action="store_true")
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    count = wrong = 0
    with tempfile.TemporaryDirectory(prefix="isogloss-programs-") as name_of_folder:
        folder = pathlib.Path(name_of_folder)
        wanted = [p for p in programs() if p[0] in options.names] if options.names else sampled(programs())
        for name, dialect, arguments, text, expected in wanted:
            found = result(options.isogloss.resolve(), folder, dialect, arguments, text)
            count += 1
            if options.show:
                print(f"{name}: {found}")
            elif found != expected:
                wrong += 1
                print(f"{name}:\n  expected {expected}\n  found    {found}")
    print(f"{count} programs, {wrong} wrong")
    return 1 if wrong or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
