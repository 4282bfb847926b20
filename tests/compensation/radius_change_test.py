#!/usr/bin/env python3
"""From which block on a radius acts that the program changes while the tool runs beside the contour.

  radius_change_test.py --isogloss PATH
"""
import argparse
import csv
import pathlib
import subprocess
import sys
import tempfile

PROGRAM = """G21 G17 G90 G94 G40
G10 L12 P1 R5.
G00 X-20. Y0 Z0
G41 D1 G01 X0 Y0 F600
Y50.
G10 L12 P1 R6.
X50.
Y0
D1 X0
G40 X-20.
M30
"""
# The end of the moves of lines 5, 7, 8 and 9.
EXPECTED = {"next-block": {5: (-5, 55), 7: (56, 56), 8: (56, -6), 9: (0, -6)},
            "next-d": {5: (-5, 55), 7: (55, 55), 8: (55, -5), 9: (0, -6)}}


def ends(isogloss, folder, choice):
    (folder / f"{choice}.xml").write_text(
        f'<Dialect xmlns="urn:isogloss:dialect:1" name="{choice}" title="{choice}" extends="fanuc"><Chain>'
        f'<Configure syntax="RadiusCompensationSyntax" table-change="{choice}"/></Chain></Dialect>\n')
    (folder / "part.nc").write_text(PROGRAM)
    run = subprocess.run([isogloss, "run", "part.nc", "-d", choice, "--dialects", folder, "--format", "csv"], cwd=folder,
                         capture_output=True, text=True, timeout=60, check=False)
    return {int(row["line"]): (float(row["px"]), float(row["py"]))
            for row in csv.DictReader(run.stdout.splitlines()) if row["px"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    options = parser.parse_args()
    failed = 0
    with tempfile.TemporaryDirectory(prefix="isogloss-radius-") as name:
        for choice, wanted in EXPECTED.items():
            got = ends(options.isogloss.resolve(), pathlib.Path(name), choice)
            for line, point in wanted.items():
                if got.get(line) != point:
                    failed += 1
                    print(f"{choice}, line {line}: expected {point}, got {got.get(line)}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
