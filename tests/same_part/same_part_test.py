#!/usr/bin/env python3
"""One part, programmed in four dialects for one machine: does the machine do the same?

  same_part_test.py --isogloss PATH [--verbose]

The part has four holes on its top and on two tilted faces: two are drilled, one is pecked, one is bored. The machine is
dialects/machines/ac-table.xml. Each program is written as that control's programmers write it; the machine positions of
all of them, rotary axes included, must agree to 1e-6 mm with each other and with positions computed here, which know
nothing of an interpreter: only the geometry of the part and of the machine.

The end of every move is compared, except for moves that go nowhere and for the point between two moves of the same kind
on one line, since one control may make one move where another makes two. The pecked hole is compared in its
characteristic points (over the hole, the level where the feed begins, the bottom, the level afterwards): how deep a
peck goes, from where its depth is counted, and how far the tool retracts differ between the controls. There every peck
must lie on the axis of the hole, be deeper than the one before, and the last one end at the bottom.
"""
import argparse
import json
import math
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "five_axis"))

from faces_test import MACHINES, machine_of  # noqa: E402
from tip_test import distance, minus, plus, times, turned  # noqa: E402

TOLERANCE = 1e-6
LENGTH = 120.0  # of the tool
WORK = [5.0, 5.0, -110.0]  # the origin of the part, in machine coordinates with the rotary axes at zero
HOME_Z = 450.0  # where the tool goes between the faces, in machine coordinates
PROGRAMS = {"fanuc": "fanuc.nc", "syntec": "syntec.nc", "siemens": "siemens.mpf", "heidenhain": "heidenhain.h"}
OFFSETS = [f"IsoCoordinateTable.G54.{axis}={at}" for axis, at in zip("XYZ", WORK)]
# What each control is told of the machine beside the machine's own file.
TABLES = {"fanuc": [f"ToolOffsetTable.1.H={LENGTH}", *OFFSETS], "syntec": [f"ToolOffsetTable.1.H={LENGTH}", *OFFSETS],
          "siemens": [f"ToolOffsetTable.1.H={LENGTH}", *(o.replace("Iso", "Siemens") for o in OFFSETS)],
          "heidenhain": [f"ToolOffsetTable.1.H={LENGTH}", *(o.replace("G54", "DATUM_PRESET_1") for o in OFFSETS)]}

# Origin of a face in the part; how it is turned about the part's X, then Y, then Z, which rest.
FACES = [((0, 0, 0), (0, 0, 0)), ((10, -40, -10), (50, 0, 20)), ((40, 10, -12), (20, 35, 0))]
ABOVE, INITIAL, CLEAR = 100.0, 50.0, 2.0  # levels over a face
HOLES = [("drilled", -10, 5, -12), ("drilled", 10, 5, -12), ("pecked", 10, -8, -20), ("bored", -10, -8, -18)]
AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def rotate(v, angles):
    for n, angle in zip(AXES, angles):
        v = turned(v, list(n), angle)
    return v


class Expected:
    """The ends of the moves, one after the other: (kind, X Y Z, A, C), and which face each belongs to."""

    def __init__(self, machine):
        self.machine, self.moves = machine, []
        for number, (origin, turn) in enumerate(FACES):
            self.origin, self.turn = list(origin), turn
            if number > 0:
                self.swivel()
            self.face()
            x, y, _ = self.moves[-1][1]
            self.add("rapid", [x, y, HOME_Z])
        self.angles = {"A": 0.0, "C": 0.0}
        self.add("rapid", self.moves[-1][1])

    angles = {"A": 0.0, "C": 0.0}

    def add(self, kind, at):
        self.moves.append((kind, at, dict(self.angles)))

    def swivel(self):
        """A table that tilts, and on it one that turns. A cannot reach the positive solution."""
        t = rotate([0.0, 0.0, 1.0], self.turn)
        a, c = -math.degrees(math.acos(t[2])), math.degrees(math.atan2(t[0], -t[1])) + 180
        self.angles = {"A": a, "C": math.remainder(c, 360)}
        self.add("rapid", self.moves[-1][1])

    def to(self, kind, *point):
        p = plus(WORK, self.origin, rotate(list(point), self.turn))
        self.add(kind, plus(self.machine.part(p, self.angles), [0.0, 0.0, LENGTH]))

    def face(self):
        _, x, y, _ = HOLES[0]
        self.to("rapid", x, y, ABOVE)
        self.to("rapid", x, y, INITIAL)
        for what, x, y, bottom in HOLES:
            self.to("rapid", x, y, INITIAL)
            self.to("rapid", x, y, CLEAR)
            self.to("feed", x, y, bottom)
            if what == "bored":
                self.to("feed", x, y, CLEAR)
            self.to("rapid", x, y, INITIAL)
        self.to("rapid", x, y, ABOVE)


def moves_of(isogloss, dialect, folder):
    """The same for a run, with its line; and the diagnostics."""
    command = [isogloss, "run", HERE / PROGRAMS[dialect], "-d", dialect, "--machine", MACHINES / "ac-table.xml", "--emit",
               "motions", "--format", "jsonl", "--exact"]
    done = subprocess.run([*command, *(a for t in TABLES[dialect] for a in ("--set", t))], cwd=folder,
                          capture_output=True, text=True, check=False)
    moves = []
    for event in map(json.loads, done.stdout.splitlines()):
        if event["Event"] in ("rapid", "feed", "arc"):
            at = event["MachineCoordinate"]
            moves.append((event["Event"], [at[a] for a in "XYZ"], {a: at.get(a, 0.0) for a in "AC"}, event["Line"]))
    return moves, done.stderr


def same_place(a, b):
    return distance(a[1], b[1]) <= TOLERANCE and all(
        abs(math.remainder(a[2][r] - b[2][r], 360)) <= TOLERANCE for r in "AC")


def on_the_way(a, b, c):
    """b lies between a and c, and the rotary axes rest."""
    u, v = minus(b[1], a[1]), minus(c[1], b[1])
    length = math.hypot(*minus(c[1], a[1]))
    if a[2] != b[2] or b[2] != c[2] or length == 0:
        return False
    return abs(math.hypot(*u) + math.hypot(*v) - length) <= TOLERANCE * 1e-3


def plain(moves, machine_home):
    """Without moves that go nowhere, and without points on a line."""
    out = [("start", machine_home, {"A": 0.0, "C": 0.0}, 0)]
    for move in moves:
        if same_place(out[-1], move):
            continue
        if len(out) > 1 and out[-1][0] == move[0] and on_the_way(out[-2], out[-1], move):
            out[-1] = move
        else:
            out.append(move)
    return out[1:]


def joined_pecks(moves, expected, fail):
    """The pecks of each pecked hole as one feed. The hole is where three positions that are expected follow each other."""
    out, position = [], 0
    for number, want in enumerate(expected):
        if position >= len(moves):
            break
        before = expected[number - 1] if number else want
        out.append(moves[position])
        position += 1
        if want[0] != "feed" or before[0] != "rapid" or same_place(out[-1], want):
            continue
        top, bottom = before[1], want[1]
        axis = times(1 / distance(top, bottom), minus(bottom, top))
        depth, peck = 0.0, out[-1]
        while True:
            way = minus(peck[1], top)
            along = sum(a * b for a, b in zip(way, axis))
            if distance(way, times(along, axis)) > TOLERANCE or along > distance(top, bottom) + TOLERANCE:
                fail(f"line {peck[3]}: a peck leaves the hole: {peck}")
                break
            if peck[0] == "feed":
                if along <= depth:
                    fail(f"line {peck[3]}: a peck that is not deeper than the one before: {peck}")
                depth = along
                if distance(peck[1], bottom) <= TOLERANCE:
                    break
            if position >= len(moves):
                fail("the pecks do not end")
                break
            peck = moves[position]
            position += 1
        out[-1] = peck
    return out + moves[position:]


def compare(name, moves, expected, fail):
    """The largest distance."""
    worst = 0.0
    if len(moves) != len(expected):
        fail(f"{name} makes {len(moves)} moves, {len(expected)} are expected")
    for got, want in zip(moves, expected):
        off = distance(got[1], want[1])
        turn = max(abs(math.remainder(got[2][r] - want[2][r], 360)) for r in "AC")
        worst = max(worst, off)
        if got[0] != want[0] or off > TOLERANCE or turn > TOLERANCE:
            fail(f"{name}, line {got[3]}:\n  {got}\n  {want} is expected")
            break
    return worst


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    isogloss = options.isogloss.resolve()
    failures = []
    home = [0.0, 260.0, 450.0]
    expected = plain([(*move, 0) for move in Expected(machine_of(MACHINES / "ac-table.xml")).moves], home)
    runs = {}
    with tempfile.TemporaryDirectory(prefix="isogloss-same-") as folder:
        for dialect in PROGRAMS:
            fail = lambda text, name=dialect: failures.append(f"{name}: {text}")  # noqa: E731
            moves, said = moves_of(isogloss, dialect, folder)
            if options.verbose:
                print(said, *moves, sep="\n")
            if "error" in said or "warning" in said:
                fail(said)
            runs[dialect] = joined_pecks(plain(moves, home), expected, fail)
            print(f"{dialect}: {len(moves)} moves, {compare(dialect, runs[dialect], expected, fail):.2g} mm off at most")
    (first, reference), *others = runs.items()
    for name, moves in others:
        worst = max((distance(a[1], b[1]) for a, b in zip(reference, moves)), default=math.inf)
        print(f"{first} and {name}: {worst:.2g} mm apart at most")
        if len(reference) != len(moves) or worst > TOLERANCE:
            failures.append(f"{first} and {name} differ")
    print("\n".join(failures[:8]))
    print(f"{len(expected)} positions, {len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
