#!/usr/bin/env python3
"""Holds `isogloss run -d syntec` against the model of syntec.py, event by event, with random programs on several machines.

  syntec_test.py --isogloss PATH [--programs N] [--seed S] [--keep DIR]

What must agree, and how a difference is shown, is as in cycles_test.py.
"""
import argparse
import pathlib
import sys
import tempfile
from fractions import Fraction

from cycles_test import Comparison, Run, check
from machine import Settings
from syntec import Syntec, SyntecProgram

# Pr17 and Pr4002, and how long the distance is in mm.
MACHINES = [(2, 1000, "1"), (2, 2000, "2"), (2, 250, "0.25"), (1, 50, "0.5"), (3, 7500, "0.75"), (2, 0, "0")]


class SyntecComparison(Comparison):
    def __init__(self, isogloss, folder, precision, count, distance):
        self.work_offset = (0, 0, 0)
        arguments = ["--set", f"SyntecParameterTable.17.Value={precision}",
                     "--set", f"SyntecParameterTable.4002.Value={count}"]
        self.runner = Run(isogloss, "syntec", folder, arguments)
        self.model, self.zero_moves = Syntec, False
        self.settings = Settings(peck=Fraction(distance), chip=Fraction(distance), tap=Fraction(distance))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--programs", type=int, default=20, help="on each machine")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path, help="write programs that differ there")
    options = parser.parse_args()
    failed = False
    with tempfile.TemporaryDirectory(prefix="isogloss-syntec-") as name:
        for number, (precision, count, distance) in enumerate(MACHINES):
            comparison = SyntecComparison(options.isogloss.resolve(), pathlib.Path(name), precision, count, distance)
            first = options.seed + 10000 * number
            seeds = range(first, first + options.programs)
            programs = [(f"Pr17={precision} Pr4002={count} seed {s}", SyntecProgram(s, comparison.settings).text)
                        for s in seeds]
            equal, differing = check(comparison, programs, options.keep)
            failed |= differing > 0 or equal < 50 * options.programs
            print(f"Pr17={precision} Pr4002={count}: {len(programs)} programs, {equal} events equal, "
                  f"{differing} programs differ")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
