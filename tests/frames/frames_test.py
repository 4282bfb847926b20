#!/usr/bin/env python3
"""Random programs of offsets and rotations against a model of the transformation from program to machine coordinates.

  frames_test.py --isogloss PATH [--programs N] [--seed S] [--keep DIR]

The model knows formulas, not frames: work offset, EXT, G52, G92 and tool length are added, G68 turns about its centre
before them. Every move of `isogloss run`, in both dialects, must end where the model does, to 1e-6 mm.
"""
import csv
import math
import pathlib
import random
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

import random_runs  # noqa: E402: it lies in another folder

PLANES = {"G17": (0, 1), "G18": (2, 0), "G19": (1, 2)}  # first and second axis
SETS = ["G54", "G55", "G56", "G57", "G58", "G59", "G54.1 P1", "G54.1 P2", "G54 P300", "G59.3"]
LENGTHS = {0: 0.0, 1: 100.0, 2: 57.3, 3: -4.0}


def plus(*vectors):
    return [sum(c) for c in zip(*vectors)]


class Machine:
    """What is in force, and where the tool stands. `rules` is the dialect."""

    def __init__(self, rules):
        self.rules = rules
        self.at = [0.0] * 3  # machine coordinates
        self.work = {s: [0.0] * 3 for s in SETS}
        self.external, self.local, self.shift = [0.0] * 3, [0.0] * 3, [0.0] * 3
        self.selected = "G54"
        self.length = 0.0
        self.untravelled = 0.0
        self.plane, self.turn, self.centre = "G17", None, None
        self.turned_plane = "G17"
        self.numbers = None  # fanuc, from G68 to the first absolute block: the program position by its numbers

    def turned(self, point, degrees, about=True):
        first, second = PLANES[self.turned_plane]
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        centre = self.centre if about else [0.0] * 3
        u, v = point[first] - centre[first], point[second] - centre[second]
        out = list(point)
        out[first], out[second] = centre[first] + u * c - v * s, centre[second] + u * s + v * c
        return out

    def offsets(self):
        tool = [0.0, 0.0, self.length]
        if self.turn is not None and self.rules == "iso":
            tool = self.turned(tool, self.turn, about=False)
        return plus(self.work[self.selected], self.external, self.local, self.shift, tool)

    def machine(self, point):
        return plus(self.turned(point, self.turn) if self.turn is not None else point, self.offsets())

    def program(self):
        """Where the tool stands, in program coordinates."""
        point = [a - b for a, b in zip(self.at, self.offsets())]
        return self.turned(point, -self.turn) if self.turn is not None else point

    def rotate(self, degrees, named):
        programmed = self.numbers or self.program()
        unturned = [a - b for a, b in zip(self.at, self.offsets())]
        self.turned_plane = self.plane
        self.centre = [named.get(a, unturned[a]) for a in range(3)]
        self.turn = degrees
        self.numbers = list(programmed) if self.rules == "fanuc" else None

    def end_rotation(self):
        self.turn = self.numbers = None

    def set_length(self, length):
        if self.rules == "fanuc":
            self.untravelled += length - self.length
        self.length = length

    def set_position(self, named):
        for axis in named:
            self.local[axis] = 0.0
        wanted = self.program()
        for axis, value in named.items():
            wanted[axis] = value
        self.shift = plus(self.shift, self.at, [-m for m in self.machine(wanted)])

    def move(self, words, incremental):
        words = dict(words)
        if 2 in words:
            if incremental:
                words[2] += self.untravelled
            self.untravelled = 0.0
        in_plane = set(words) & set(PLANES[self.turned_plane])
        if self.numbers and incremental:
            step = [words.get(a, 0.0) for a in range(3)]
            self.numbers = plus(self.numbers, step)
            self.at = plus(self.at, self.turned(step, self.turn, about=False))
            return
        if self.numbers and not in_plane:
            for axis, value in words.items():  # the third axis alone
                self.numbers[axis] = value
                self.at[axis] = value + self.offsets()[axis]
            return
        target = self.numbers or self.program()
        self.numbers = None
        for axis, value in words.items():
            target[axis] = target[axis] + value if incremental else value
        self.at = self.machine(target)


class Program:
    """Random blocks and, by line, the machine coordinates that they end at."""

    def __init__(self, seed, rules, blocks=150):
        self.random = random.Random(seed)
        self.rules, self.machine = rules, Machine(rules)
        self.lines, self.ends = [], {}
        self.incremental = False
        steps = [(30, self.move), (6, self.select), (4, self.table), (4, self.local), (4, self.position), (4, self.length),
                 (8, self.rotation), (3, self.distance), (2, self.plane)]
        self.write("G90 G54 G17 G21 G49 G69")
        for step in self.random.choices([s for _, s in steps], [w for w, _ in steps], k=blocks):
            step()
        self.write("M30")

    def write(self, text):
        self.lines.append(text)

    def value(self, low=-100, high=100):
        return round(self.random.uniform(low, high), 3)

    def words(self, least=1):
        axes = self.random.sample(range(3), self.random.randint(least, 3))
        return {a: self.value() for a in axes}

    @staticmethod
    def text(words):
        return " ".join("XYZ"[a] + f"{v:.3f}" for a, v in words.items())

    def move(self, prefix=""):
        words = self.words()
        self.write(f"{prefix}{self.random.choice(('G00', 'G01 F500', ''))} {self.text(words)}".strip())
        self.machine.move(words, self.incremental)
        self.ends[len(self.lines)] = list(self.machine.at)

    def select(self):
        if self.machine.turn is not None:
            return
        sets = SETS if self.machine.rules == "iso" else SETS[:-1]
        self.machine.selected = self.random.choice(sets)
        if self.random.random() < 0.5:
            self.move(self.machine.selected + " ")
        else:
            self.write(self.machine.selected)

    def table(self):
        words = self.words()
        row = self.random.choice(SETS[:9] + ["EXT"])
        if self.machine.turn is not None:
            return
        where = "L2 P0" if row == "EXT" else f"L2 P{SETS.index(row) + 1}" if "P" not in row else "L20 " + row.split()[1]
        self.write(f"G10 {where} {self.text(words)}")
        origin = self.machine.external if row == "EXT" else self.machine.work[row]
        for axis, value in words.items():
            origin[axis] = origin[axis] + value if self.incremental else value

    def local(self):
        if self.machine.turn is not None:
            return
        words = self.words()
        self.write("G52 " + self.text(words))
        for axis, value in words.items():
            self.machine.local[axis] = value

    def position(self):
        if self.machine.turn is not None:
            return
        words = self.words()
        if self.random.random() < 0.3:
            self.write("G92.1 " + " ".join("XYZ"[a] + "0" for a in words))
            for axis in words:
                self.machine.shift[axis] = self.machine.local[axis] = 0.0
            return
        self.write("G92 " + self.text(words))
        self.machine.set_position(words)

    def length(self):
        if self.machine.turn is not None:
            return
        row = self.random.choice(list(LENGTHS))
        code = self.random.choice(("G43", "G44", "G49"))
        self.machine.set_length({"G43": 1, "G44": -1, "G49": 0}[code] * LENGTHS[row])
        block = code if code == "G49" else f"{code} H{row}"
        if self.random.random() < 0.5:
            self.move(block + " ")
        else:
            self.write(block)

    def rotation(self):
        if self.machine.turn is not None and self.random.random() < 0.6:
            self.machine.end_rotation()
            if self.random.random() < 0.5:
                self.move("G69 ")
            else:
                self.write("G69")
            return
        degrees = self.random.choice((self.value(-360, 360), 90.0, -90.0, 180.0, 0.0))
        axes = self.random.sample(PLANES[self.machine.plane], self.random.randint(0, 2))
        named = {a: self.value() for a in axes}
        self.machine.rotate(degrees, named)
        self.write(f"G68 {self.text(named)} R{degrees:.3f}")

    def distance(self):
        self.incremental = not self.incremental
        self.write("G91" if self.incremental else "G90")

    def plane(self):
        if self.machine.turn is not None:
            return
        self.machine.plane = self.random.choice(list(PLANES))
        self.write(self.machine.plane)


def difference(isogloss, folder, program):
    """(moves compared, how the first different one differs, or None)"""
    (folder / "in.nc").write_text("\n".join(program.lines) + "\n")
    settings = [w for row, mm in LENGTHS.items() if row for w in ("--set", f"ToolOffsetTable.{row}.H={mm}")]
    run = subprocess.run([isogloss, "run", "in.nc", "-d", program.rules, "--emit", "motions", "--format", "csv", "--exact",
                          "--zero-moves", *settings], cwd=folder, capture_output=True, text=True, timeout=60, check=False)
    if run.returncode != 0:
        return 0, f"isogloss ends with {run.returncode}: {run.stderr[:600]}"
    ends = {int(row["line"]): [float(row[c]) for c in ("mx", "my", "mz")]
            for row in csv.DictReader(run.stdout.splitlines()) if row["event"] in ("rapid", "feed")}
    if ends.keys() != program.ends.keys():
        return 0, f"lines that move: {sorted(ends.keys() ^ program.ends.keys())}"
    for count, (line, wanted) in enumerate(sorted(program.ends.items())):
        if math.dist(wanted, ends[line]) > 1e-6:
            return count, f"line {line}, {program.lines[line - 1]}: {ends[line]} instead of {wanted}"
    return len(ends), None


OPTIONS = """<?xml version="1.0" encoding="UTF-8"?>
<Dialect xmlns="urn:isogloss:dialect:1" name="other" title="The other values of the options" extends="fanuc">
  <Chain>
    <Configure syntax="WorkCoordinateShiftSyntax" reference-return="cancel"/>
    <Configure syntax="IsoG68RotationSyntax" incremental-angle="g91" unnamed-axis="rotated"/>
    <Configure syntax="ProgrammableDataInputSyntax" tool-columns="wear-geometry"/>
  </Chain>
</Dialect>
"""
OPTION_MOVES = [  # block, machine coordinates that it ends at
    ("G90 G54 G00 X10. Y10. Z50.", (10, 10, 50)),
    ("G92 X0 Y0 Z0", None),
    ("G91 G28 Z0", (10, 10, 0)),
    ("G90 X1. Y1. Z-5.", (11, 11, -5)),  # the shift of Z went with G28, the others did not
    ("G92.1", None),
    ("X10. Y0. Z0.", (10, 0, 0)),
    ("G68 X0 Y0 R30.", None),
    ("G91 G68 X0 Y0 R60.", None),
    ("G90 X20.", (10, 20, 0)),  # 90 degrees; Y is -10 where the tool stands
    ("G69 X0. Y0.", (0, 0, 0)),
    ("G10 L11 P9 R100.", None),
    ("G10 L10 P9 R-1.", None),
    ("G91 G10 L11 P9 R0.5", None),
    ("G90 G43 H9 Z1.", (0, 0, 100.5)),
]


def option_difference(isogloss, folder):
    """How the program of the other options differs from what it should do, or None."""
    (folder / "other.xml").write_text(OPTIONS)
    (folder / "in.nc").write_text("\n".join(block for block, _ in OPTION_MOVES) + "\n")
    run = subprocess.run([isogloss, "run", "in.nc", "-d", "other.xml", "--emit", "motions", "--format", "csv"], cwd=folder,
                         capture_output=True, text=True, timeout=60, check=False)
    ends = {int(row["line"]): tuple(float(row[c]) for c in ("mx", "my", "mz"))
            for row in csv.DictReader(run.stdout.splitlines()) if row["event"] == "rapid"}
    for line, (block, wanted) in enumerate(OPTION_MOVES, 1):
        if ends.get(line) != wanted:
            return f"line {line}, {block}: {ends.get(line)} instead of {wanted} {run.stderr[:600]}"
    return None


if __name__ == "__main__":
    sys.exit(random_runs.run(__doc__, Program, difference, ".nc", ("iso", "fanuc"), 25, option_difference))
