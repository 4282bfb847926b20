#!/usr/bin/env python3
"""A golden program of each of three dialects under valgrind: no wrong access, nothing lost, the expected motions.

  valgrind.py --isogloss PATH [DIALECT/ROOM/NAME...]
"""
import argparse
import pathlib
import subprocess
import sys

from regenerate import HERE, command_of

PROGRAMS = ("fanuc/demo", "siemens/cycles/cycles", "heidenhain/cycles/cycles")
FAULT = 99


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("names", nargs="*", default=PROGRAMS)
    options = parser.parse_args()
    failed = 0
    for name in options.names:
        program = (HERE / name).with_suffix(".nc")
        run = subprocess.run(["valgrind", "--quiet", f"--error-exitcode={FAULT}", "--leak-check=full",
                              "--errors-for-leak-kinds=definite", *command_of(options.isogloss.resolve(), program)],
                             cwd=program.parent, capture_output=True, text=True, check=False)
        sound = run.returncode in (0, 1) and run.stdout == program.with_suffix(".motions.csv").read_text()
        failed += not sound
        print(f"{name}: {'sound' if sound else f'exit status {run.returncode}'}")
        if not sound:
            print(run.stderr if run.returncode not in (0, 1) else "its motions are not those expected")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
