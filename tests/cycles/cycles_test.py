#!/usr/bin/env python3
"""Compares `isogloss run` with the models of machine.py (dialect fanuc) and reference.py (dialect iso), event by event.

  cycles_test.py --isogloss PATH [--dialect fanuc|iso] [--cycles G81,G82] [--programs N] [--seed S] [--keep DIR]
                 [FILE.nc...]

Programs are the worked examples of worked_lists.txt and N random ones for each dialect, and under fanuc some more for
machines with other parameters and a work offset. Positions, those of the program, must agree to 1e-6 mm, feeds and
dwells to 1e-6; so must lines, spindle, coolant, stops and the end. Errors in diagnostics are a difference too, unless
the model knows that the block has words that no syntax takes. A program that differs is shortened as long as it
still differs, then printed with both sides.
"""
import argparse
import itertools
import json
import pathlib
import subprocess
import sys
import tempfile
from fractions import Fraction

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import budgeted  # noqa: E402: it lies in another folder

import events
import worked_lists
from machine import Machine, Settings, Uncertain
from random_programs import RandomProgram
from reference import Reference

# The cycles that the shipped dialects carry out.
CYCLES = "G73,G74,G76,G81,G82,G83,G84,G85,G86,G87,G88,G89"
MODELS = {"fanuc": Machine, "iso": Reference}
BATCH = 100
# Machines as their builders may have set them.
OTHERS = [Settings(peck=Fraction("0.5"), chip=Fraction("0.25"), tap=Fraction(2), tap_to_r=True, shift="-X"),
          Settings(shift="+Y"), Settings(chip=Fraction(2), shift="-Y")]
WORK_OFFSET = (-310.5, -120.25, -480)  # on those machines


def parameters(settings):
    """The arguments that give `isogloss run` the same machine."""
    increments = {5115: settings.peck, 5114: settings.chip, 5213: settings.tap}
    numbers = {number: int(value * 1000) for number, value in increments.items()}
    numbers[5200] = 32 if settings.tap_to_r else 0
    numbers[5101] = {"+X": 0, "-X": 16, "+Y": 32, "-Y": 48}[settings.shift]
    tables = [f"FanucParameterTable.{number}.Value={value}" for number, value in numbers.items()]
    tables += [f"IsoCoordinateTable.G54.{axis}={value}" for axis, value in zip("XYZ", WORK_OFFSET)]
    return [argument for value in tables for argument in ("--set", value)]


class Run:
    """The output of `isogloss run` for several programs in one process."""

    def __init__(self, isogloss, dialect, folder, arguments):
        self.command = [isogloss, "run", "-d", dialect, "--emit", "motions", "--format", "jsonl", "--exact",
                        "--diagnostics", "json", "--repeats", "0", *arguments]
        self.folder = folder

    def programs(self, texts):
        names = [f"p{number}.nc" for number in range(len(texts))]
        for name, text in zip(names, texts):
            (self.folder / name).write_text(text)
        run = subprocess.run([*self.command, *names], cwd=self.folder, capture_output=True, text=True, check=False)
        if run.returncode > 1:
            raise RuntimeError(f"isogloss ends with {run.returncode}: {run.stderr[:2000]}")
        rows, said = {n: [] for n in names}, {n: [] for n in names}
        for line in run.stdout.splitlines():
            row = json.loads(line)
            rows[row["File"]].append(row)
        for line in run.stderr.splitlines():
            diagnostic = json.loads(line)
            if diagnostic.get("File") in said:
                said[diagnostic["File"]].append(diagnostic)
        return [(rows[n], said[n]) for n in names]


class Comparison:
    def __init__(self, isogloss, dialect, folder, zero_moves=False, settings=None):
        self.work_offset = WORK_OFFSET if settings else (0, 0, 0)
        arguments = ["--zero-moves"] if zero_moves else []
        self.runner = Run(isogloss, dialect, folder, arguments + (parameters(settings) if settings else []))
        self.model, self.zero_moves, self.settings = MODELS[dialect], zero_moves, settings

    def expected(self, text):
        model = self.model(self.settings)
        model.at = [Fraction(-o) for o in self.work_offset]  # the home position
        model.run(text)
        return model

    def comparable(self, model, happened):
        happened = events.settled(happened)
        if not self.zero_moves:
            happened = events.moves_only(happened, [-o for o in self.work_offset])
        return [e for e in happened if not (e.kind == "spindle" and e.line in model.loose_lines)]

    def report(self, text, rows, said):
        """(number of equal events, None) or (…, what differs, both sides)"""
        model = self.expected(text)
        for diagnostic in said:
            if diagnostic["Severity"] == "error" and diagnostic["Line"] not in model.unused_lines:
                return 0, f"line {diagnostic['Line']}: {diagnostic['Message']} [{diagnostic['Code']}]"
        expected = self.comparable(model, model.events)
        got = self.comparable(model, events.from_stream(rows, self.work_offset))
        for number, (a, b) in enumerate(itertools.zip_longest(expected, got)):
            what = events.differ(a, b)
            if what:
                line = (a or b).line
                source = text.splitlines()[line - 1]
                return number, f"line {line}, {source}: {what}\n{side_by_side(expected, got, number)}"
        return len(expected), None

    def shrink(self, text):
        """Leaves out one block after the other, as long as something differs and the model is sure."""
        lines, size = text.splitlines(), max(1, len(text.splitlines()) // 2)
        while size:
            position = len(lines) - size
            shorter = False
            while position >= 0:
                fewer = lines[:position] + lines[position + size:]
                if fewer and self.differs("\n".join(fewer) + "\n"):
                    lines, shorter = fewer, True
                position -= size
            size = size if shorter and size == 1 else size // 2
        return "\n".join(lines) + "\n"

    def differs(self, text):
        try:
            self.expected(text)
        except Uncertain:
            return False
        [(rows, said)] = self.runner.programs([text])
        return self.report(text, rows, said)[1] is not None


def side_by_side(expected, got, number, around=6):
    table = [("expected", "got")]
    for index in range(max(0, number - around), number + around):
        pair = [side[index] if index < len(side) else None for side in (expected, got)]
        if any(pair):
            table.append([f"{'*' if index == number else ' '} {e.line}: {e}" if e else "" for e in pair])
    width = max(len(left) for left, _ in table)
    return "\n".join(f"    {left.ljust(width)}  {right}" for left, right in table)


def numbered(text):
    return "".join(f"    {number:3} {row}\n" for number, row in enumerate(text.splitlines(), 1))


def examples(cycles, settings):
    """Worked examples of that machine, for the selected cycles."""
    for example in worked_lists.read():
        codes = {c for c in Machine.CYCLES if f"G{c} " in example.program}
        if example.settings == settings and codes <= set(cycles):
            yield example.title, example.program


def plans(programs):
    """(dialect, keep moves that go nowhere, machine if not the shipped one, random programs)"""
    yield "fanuc", False, None, programs
    yield "iso", False, None, programs
    yield "iso", True, None, programs
    machines = OTHERS + [e.settings for e in worked_lists.read() if e.settings not in OTHERS + [Settings()]]
    for number, machine in enumerate(machines):
        yield "fanuc", False, machine, (programs + 3) // 4 if number < len(OTHERS) else 0


def check(comparison, programs, keep):
    equal = differing = 0
    for start in range(0, len(programs), BATCH):
        batch = programs[start:start + BATCH]
        for (title, text), (rows, said) in zip(batch, comparison.runner.programs([t for _, t in batch])):
            count, report = comparison.report(text, rows, said)
            equal += count
            if report is None:
                continue
            differing += 1
            if differing <= 5:
                text = comparison.shrink(text)
                [(rows, said)] = comparison.runner.programs([text])
                print(f"{title}: {comparison.report(text, rows, said)[1]}\n{numbered(text)}")
            if keep:
                keep.mkdir(parents=True, exist_ok=True)
                (keep / f"{title.replace(' ', '_')}.nc").write_text(text)
    return equal, differing


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--dialect", choices=MODELS, help="default: both")
    parser.add_argument("--cycles", default=CYCLES)
    parser.add_argument("--programs", type=int, default=budgeted(60))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path, help="write programs that differ there")
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    cycles = [int(c.strip().lstrip("G")) for c in options.cycles.split(",")]
    failed = False
    with tempfile.TemporaryDirectory(prefix="isogloss-cycles-") as name:
        for dialect, zero_moves, machine, count in plans(options.programs):
            if options.dialect not in (None, dialect):
                continue
            comparison = Comparison(options.isogloss.resolve(), dialect, pathlib.Path(name), zero_moves, machine)
            programs = [(f.name, f.read_text()) for f in options.files]
            if not programs:
                numbers = range(options.seed, options.seed + count)
                programs = [(f"{dialect} seed {s}", RandomProgram(s, MODELS[dialect], cycles).text) for s in numbers]
                programs += examples(cycles, machine or Settings()) if dialect == "fanuc" else []
            equal, differing = check(comparison, programs, options.keep)
            failed |= differing > 0
            print(f"{dialect}{' with moves that go nowhere' if zero_moves else ''}"
                  f"{' ' + ' '.join(parameters(machine)[1:10:2]) if machine else ''}: {len(programs)} programs, "
                  f"{equal} events equal, {differing} programs differ".replace("FanucParameterTable.", ""))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
