#!/usr/bin/env python3
"""Compares `isogloss run -d syntec` with the model of syntec.py, event by event, with random programs on several
machines.

  syntec_test.py --isogloss PATH [--programs N] [--seed S] [--keep DIR]

First the worked examples of worked_lists.txt, as they are typed in: a Syntec executes the same steps, with Pr4002 as
the one distance. Not compared: the spindle events of tapping, which is rigid here, and machines that shift the tool
along another axis, which is an option of the dialect. What must agree, and how a difference is shown, is as in
cycles_test.py.
"""
import argparse
import copy
import itertools
import pathlib
import sys
import tempfile
from fractions import Fraction

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import budgeted  # noqa: E402: it lies in another folder

import events
import worked_lists
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


def steps(happened, without_spindle):
    for event in happened:
        event = copy.copy(event)
        event.line, event.speed = 0, None
        if not (without_spindle and event.kind == "spindle"):
            yield event


def worked(isogloss, folder):
    """The worked examples: how many events are equal, how many examples differ."""
    equal = differing = 0
    for example in worked_lists.read():
        if example.settings.shift != "+X" or example.settings.tap_to_r:
            continue
        distance = example.settings.chip if "G73" in example.program else example.settings.peck
        runner = Run(isogloss, "syntec", folder, ["--set", f"SyntecParameterTable.4002.Value={int(distance * 1000)}"])
        [(rows, said)] = runner.programs([example.program.replace("M29 ", "")])
        tapping = "G84" in example.program or "G74" in example.program
        got = list(steps((e for e in events.settled(events.from_stream(rows)) if e.line > 2), tapping))
        expected = list(steps(example.events, tapping))
        parts = [n for n, (a, b) in enumerate(itertools.zip_longest(expected, got)) if events.differ(a, b)]
        equal += len(expected) if not parts else parts[0]
        if parts or any(d["Severity"] == "error" for d in said):
            differing += 1
            sides = (f"{a}  |  {b}" for a, b in itertools.zip_longest(expected, got))
            print(f"{example.title}:", *sides, said, sep="\n    ")
    return equal, differing


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--programs", type=int, default=budgeted(20), help="on each machine")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path, help="write programs that differ there")
    options = parser.parse_args()
    failed = False
    with tempfile.TemporaryDirectory(prefix="isogloss-syntec-") as name:
        equal, differing = worked(options.isogloss.resolve(), pathlib.Path(name))
        failed |= differing > 0 or equal < 150
        print(f"worked examples: {equal} events equal, {differing} examples differ")
        for number, (precision, count, distance) in enumerate(MACHINES):
            comparison = SyntecComparison(options.isogloss.resolve(), pathlib.Path(name), precision, count, distance)
            first = options.seed + 10000 * number
            numbers = range(first, first + options.programs)
            programs = [(f"Pr17={precision} Pr4002={count} seed {s}", SyntecProgram(s, comparison.settings).text)
                        for s in numbers]
            equal, differing = check(comparison, programs, options.keep)
            failed |= differing > 0 or equal < 50 * options.programs
            print(f"Pr17={precision} Pr4002={count}: {len(programs)} programs, {equal} events equal, "
                  f"{differing} programs differ")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
