#!/usr/bin/env python3
"""Random five-axis programs on random machines: is the tip of the tool where the program says?

  tip_test.py --isogloss PATH [--programs N] [--seed S] [--keep DIR]

The machine is walked forwards, from its axes to the tip: heads turn the tool that hangs from the gauge point, tables
carry the workpiece. The inverse direction, which the interpreter computes, is not used. Every move of `isogloss run`
must bring the tip to the programmed point of the workpiece within 1e-6 mm, and the tool to the programmed direction
within 1e-9.
"""
import argparse
import math
import pathlib
import random
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

import dialect_programs  # noqa: E402: the path must come first
from budget import budgeted  # noqa: E402: it lies in another folder

LETTERS = "ABC"
NATURAL = {"A": (1.0, 0.0, 0.0), "B": (0.0, 1.0, 0.0), "C": (0.0, 0.0, 1.0)}
NUTATING = (0.0, math.sqrt(0.5), math.sqrt(0.5))  # inclined by 45 degrees
# Letters and places, the axis nearer the machine's base first; an inclined axis says its direction.
# These reach every direction of the upper half:
REACHING = [
    [("A", "table", None), ("C", "table", None)],
    [("B", "table", None), ("C", "table", None)],
    [("A", "table", None), ("B", "table", None)],
    [("B", "table", None), ("A", "table", None)],
    [("C", "head", None), ("A", "head", None)],
    [("C", "head", None), ("B", "head", None)],
    [("A", "head", None), ("B", "head", None)],
    [("B", "head", None), ("C", "table", None)],
    [("A", "head", None), ("C", "table", None)],
    [("B", "head", None), ("A", "table", None)],
    [("A", "head", None), ("B", "table", None)],
    [("C", "head", None), ("B", "head", NUTATING)],
    [("B", "head", NUTATING), ("C", "table", None)],
    [("B", "table", NUTATING), ("C", "table", None)],
]
OTHERS = [
    [("C", "table", None), ("A", "table", None)],
    [("A", "table", NUTATING), ("B", "table", None)],
    [("A", "table", None)],
    [("B", "head", None)],
]
MACHINES = REACHING + OTHERS


def plus(*vectors):
    return [sum(c) for c in zip(*vectors)]


def minus(u, v):
    return [a - b for a, b in zip(u, v)]


def times(s, v):
    return [s * c for c in v]


def inner(u, v):
    return sum(a * b for a, b in zip(u, v))


def turned(v, n, degrees):
    """v turned right-handed about the unit vector n."""
    q = math.radians(math.remainder(degrees, 360))
    c, s = math.cos(q), math.sin(q)
    cross = [n[1] * v[2] - n[2] * v[1], n[2] * v[0] - n[0] * v[2], n[0] * v[1] - n[1] * v[0]]
    return plus(times(c, v), times((1 - c) * inner(n, v), n), times(s, cross))


def distance(u, v):
    return math.dist(u, v)


class Machine:
    def __init__(self, rng, shape):
        self.axes = []
        for letter, place, n in shape:
            point = [rng.uniform(-80, 80), rng.uniform(-80, 80), rng.uniform(-200, 150)]
            self.axes.append((letter, place, list(n or NATURAL[letter]), point))
        self.letters = [a[0] for a in self.axes]
        # What the builder has chosen: on some machines the scale runs the other way, or does not begin at the geometric zero.
        self.signs = {a: rng.choice([1, 1, -1]) for a in self.letters}
        self.zeros = {a: rng.choice([0.0, 0.0, round(rng.uniform(-90, 90), 4)]) for a in self.letters}

    @classmethod
    def of(cls, axes):
        """A machine whose axes are given: letter, place, direction and point."""
        machine = cls(random.Random(0), [])
        machine.axes = [(letter, place, list(n), list(point)) for letter, place, n, point in axes]
        machine.letters = [a[0] for a in axes]
        return machine

    def geometric(self, letter, angles):
        return self.signs.get(letter, 1) * (angles[letter] - self.zeros.get(letter, 0.0))

    def xml(self):
        rows = []
        for i, (letter, place, n, point) in enumerate(self.axes):
            values = [("X", n[0]), ("Y", n[1]), ("Z", n[2]), ("PivotX", point[0]), ("PivotY", point[1]),
                      ("PivotZ", point[2]), ("Sign", self.signs[letter]), ("Zero", self.zeros[letter])]
            rows.append(f'<Axis name="{letter}" Place="{place}" Order="{i + 1}" ' +
                        " ".join(f'{k}="{v:.17f}"' for k, v in values) + "/>")
        return "<MachineKinematics>" + "".join(rows) + "</MachineKinematics>"

    def part(self, p, angles):
        """Where a point of the workpiece stands, all axes at zero: p, in machine coordinates."""
        for letter, place, n, point in reversed(self.axes):
            if place == "table":
                p = plus(point, turned(minus(p, point), n, -self.geometric(letter, angles)))
        return p

    def in_workpiece(self, p, angles):
        """The inverse: the point of the workpiece that stands at p."""
        for letter, place, n, point in self.axes:
            if place == "table":
                p = plus(point, turned(minus(p, point), n, self.geometric(letter, angles)))
        return p

    def hanging(self, v, angles):
        """A point of the tool, from the gauge point: v with all axes at zero."""
        for letter, place, n, point in reversed(self.axes):
            if place == "head":
                v = plus(point, turned(minus(v, point), n, self.geometric(letter, angles)))
        return v

    def tip(self, at, angles, length):
        return plus(at, self.hanging([0.0, 0.0, -length], angles))

    def direction(self, angles):
        """The direction of the tool as seen from the workpiece: heads turn it, tables turn the workpiece away."""
        t = [0.0, 0.0, 1.0]
        for letter, place, n, _ in reversed(self.axes):
            if place == "head":
                t = turned(t, n, self.geometric(letter, angles))
        for letter, place, n, _ in self.axes:
            if place == "table":
                t = turned(t, n, self.geometric(letter, angles))
        return t


class Program:
    """Writes blocks, and remembers where the tip is to be."""

    def __init__(self, rng, machine):
        self.rng, self.machine = rng, machine
        self.work = [rng.uniform(-100, 100) for _ in range(3)]
        # The program counts the rotary axes from here.
        self.turned = {a: rng.choice([0.0, round(rng.uniform(-40, 40), 4)]) for a in machine.letters}
        self.lengths = {1: 120.0, 2: rng.uniform(30, 200)}
        self.length = 0.0
        self.lines, self.wanted = [], {}
        self.point, self.angles = None, {a: 0.0 for a in machine.letters}
        self.plane = None  # origin and the three directions

    def write(self, text):
        self.lines.append(text)
        return len(self.lines)

    def workpiece(self, p):
        if self.plane:
            origin, x, y, z = self.plane
            p = plus(origin, times(p[0], x), times(p[1], y), times(p[2], z))
        return plus(self.work, p)

    def expect(self, line, direction=None):
        angles = None if direction else dict(self.angles)
        self.wanted[line] = (self.workpiece(self.point), angles, direction, self.length)

    def number(self, low, high):
        return round(self.rng.uniform(low, high), 4)

    def activate(self, code="G43.4"):
        h = self.rng.choice([1, 2])
        self.length = self.lengths[h]
        self.point = [self.number(-60, 60) for _ in range(3)]
        rotary = self.rotary_words() if code == "G43.4" and self.rng.random() < 0.5 else ""
        if rotary or self.rng.random() < 0.5:
            line = self.write(f"G00 {code} H{h} {self.xyz()}{rotary}")
        else:
            self.write(f"{code} H{h}")
            line = self.write(f"G00 {self.xyz()}")
        if code == "G43.4":
            self.expect(line)

    def xyz(self):
        return " ".join(f"{a}{c:.4f}" for a, c in zip("XYZ", self.point))

    def rotary_words(self):
        text = ""
        for letter in self.machine.letters:
            if self.rng.random() < 0.7:
                self.angles[letter] = self.number(-170, 170)
                text += self.word(letter)
        return text

    def word(self, letter):
        return f" {letter}{self.angles[letter] - self.turned[letter]:.4f}"

    def absolute(self):
        text = self.rng.choice(["", "G00 ", "G01 ", "G01 F800. "])
        named = [a for a in range(3) if self.rng.random() < 0.6]
        for a in named:
            self.point[a] = self.number(-60, 60)
            text += f"{'XYZ'[a]}{self.point[a]:.4f} "
        text += self.rotary_words()
        if text.strip(" G01F8."):
            self.expect(self.write("G90 " + text))

    def incremental(self):
        text = "G91 G01 F500. "
        for a in range(3):
            if self.rng.random() < 0.5:
                d = self.number(-20, 20)
                self.point[a] += d
                text += f"{'XYZ'[a]}{d:.4f} "
        for letter in self.machine.letters:
            if self.rng.random() < 0.5:
                d = self.number(-60, 60)
                self.angles[letter] += d
                text += f"{letter}{d:.4f} "
        if len(text) > 14:
            self.expect(self.write(text))

    def new_length(self):
        h = self.rng.choice([1, 2])
        at = self.point
        # The machine rests: the tip's point moves along the tool by the change.
        change = self.lengths[h] - self.length
        t = self.machine.direction(self.angles)
        if self.plane:
            t = [inner(t, d) for d in self.plane[1:]]
        self.length = self.lengths[h]
        self.point = minus(at, times(change, t))
        line = self.write(f"H{h}")
        self.point[2] = self.number(-60, 60)
        line = self.write(f"G90 G01 F300. Z{self.point[2]:.4f}")
        self.expect(line)

    def vector(self):
        d = [round(self.rng.gauss(0, 1), 6) for _ in range(3)]
        self.point = [self.number(-60, 60) for _ in range(3)]
        t = times(1 / math.sqrt(inner(d, d)), d)
        if self.plane:
            t = plus(*(times(c, e) for c, e in zip(t, self.plane[1:])))
        if t[2] < 0:  # what every machine here reaches
            d, t = times(-1, d), times(-1, t)
        line = self.write(f"G90 G01 F900. {self.xyz()} I{d[0]:.6f} J{d[1]:.6f} K{d[2]:.6f}")
        self.expect(line, direction=t)

    def tilt(self):
        i, j, k = (self.number(-180, 180) for _ in range(3))
        j = self.number(-75, 75)
        origin = [self.number(-30, 30) for _ in range(3)]
        dirs = [[1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0]]
        for n, a in (([0, 0, 1.0], k), ([1.0, 0, 0], j), ([0, 0, 1.0], i)):
            dirs = [turned(v, n, a) for v in dirs]
        self.write(f"G90 G68.2 X{origin[0]:.4f} Y{origin[1]:.4f} Z{origin[2]:.4f} I{i:.4f} J{j:.4f} K{k:.4f}")
        self.plane = (origin, *dirs)


    def upright(self):
        """3+2: the plane, the tool upright on it, moves in the plane."""
        keeps_tip = self.rng.random() < 0.4
        if keeps_tip:
            self.write("G49")
            self.length = self.lengths[1]
            self.write("G43 H1")
            self.point = [self.number(-60, 60) for _ in range(3)]
            self.write(f"G90 G00 {self.xyz()}")
            # Off the plane nothing follows the axes: the tip stands where they have put it, be zero where it may.
            tip = self.machine.tip(plus(self.work, self.point, [0.0, 0.0, self.length]), self.angles, self.length)
            resting = minus(self.machine.in_workpiece(tip, self.angles), self.work)
        self.tilt()
        normal = self.plane[3]
        if keeps_tip:
            line = self.write("G53.6")
            away = minus(resting, self.plane[0])
            self.point = [inner(away, d) for d in self.plane[1:]]
            self.expect(line, direction=normal)
        else:
            self.write("G53.1")
            h = self.rng.choice([1, 2])
            self.length = self.lengths[h]
            self.write(f"G43 H{h}")
        for _ in range(self.rng.randint(1, 5)):
            self.point = [self.number(-60, 60) for _ in range(3)]
            self.expect(self.write(f"G90 G00 {self.xyz()}"), direction=normal)

    def level(self):
        self.write("G69")
        self.write("G49")
        self.plane, self.length, self.angles = None, 0.0, {a: 0.0 for a in self.machine.letters}
        self.write("G90 G00" + "".join(map(self.word, self.machine.letters)))


def make(rng, shape):
    machine = Machine(rng, shape)
    p = Program(rng, machine)
    p.write("G21 G90 G94 G17 G54")
    kind = rng.choice(["angles", "angles", "vectors", "planes", "vectors in a plane", "angles in a plane"])
    if shape in OTHERS:
        kind = "angles"
    if kind == "planes":
        for _ in range(6):
            p.upright()
            p.level()
    else:
        if "plane" in kind:
            p.tilt()
            p.write("G53.1")
        p.activate("G43.4" if "angles" in kind else "G43.5")
        if "plane" in kind and "angles" in kind:  # where G53.1 has left the axes is the control's choice
            p.angles = {a: 0.0 for a in machine.letters}
            p.expect(p.write("G90 G01 F100. Z1." + "".join(map(p.word, machine.letters))))
            p.point[2] = 1.0
            p.wanted.clear()
        for _ in range(40):
            if "vectors" in kind:
                p.vector()
            else:
                rng.choice([p.absolute, p.absolute, p.absolute, p.incremental, p.new_length])()
    p.write("G49")
    p.write("M30")
    return machine, p


def run(isogloss, plugins, folder, machine, program):
    offsets = " ".join(f'{a}="{c!r}"' for a, c in [*zip("XYZ", program.work), *program.turned.items()])
    tools = "".join(f'<Tool id="{h}" H="{length!r}"/>' for h, length in program.lengths.items())
    (folder / "five.xml").write_text(f"""<?xml version="1.0" encoding="UTF-8"?>
<Dialect xmlns="urn:isogloss:dialect:1" name="five" title="five axes" extends="iso">
  <Plugins><Plugin name="kinematics"/></Plugins>
  <Dependencies>
    <IsoCoordinateTable><Offset id="G54" {offsets}/></IsoCoordinateTable>
    <ToolOffsetTable>{tools}</ToolOffsetTable>
    {machine.xml()}
  </Dependencies>
</Dialect>
""")
    (folder / "five.nc").write_text("\n".join(program.lines) + "\n")
    return dialect_programs.motions(isogloss, plugins, folder, "five")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--plugins")
    parser.add_argument("--programs", type=int, default=budgeted(60))
    parser.add_argument("--seed", type=int, default=4)
    parser.add_argument("--keep", type=pathlib.Path)
    options = parser.parse_args()
    isogloss = options.isogloss.resolve()
    worst_mm = worst_direction = 0.0
    checked = 0
    failures = []
    with tempfile.TemporaryDirectory(prefix="isogloss-five-axis-") as name:
        folder = options.keep or pathlib.Path(name)
        folder.mkdir(exist_ok=True)
        for n in range(options.programs):
            rng = random.Random(f"{options.seed}/{n}")
            shape = MACHINES[n % len(MACHINES)]
            machine, program = make(rng, shape)
            events, said = run(isogloss, options.plugins, folder, machine, program)
            seen = {}
            for event in events:
                if event.get("Event") in ("rapid", "feed", "arc"):
                    seen[event["Line"]] = event
            for line, (wanted, angles, direction, length) in program.wanted.items():
                event = seen.get(line)
                if event is None:
                    # A block that goes to where the tool stands already makes no event.
                    earlier = [e for e in seen if e < line]
                    if not earlier:
                        failures.append(f"program {n}, line {line}: no move: {program.lines[line - 1]}\n{said}")
                        break
                    event = seen[max(earlier)]
                at = event["MachineCoordinate"]
                xyz = [at[a] for a in "XYZ"]
                has = {a: at.get(a, 0.0) for a in machine.letters}
                off = distance(machine.tip(xyz, has, length), machine.part(wanted, has))
                t = direction or machine.direction(angles)
                lean = distance(machine.direction(has), t)
                checked += 1
                worst_mm, worst_direction = max(worst_mm, off), max(worst_direction, lean)
                if off > 1e-6 or lean > 1e-9:
                    failures.append(f"program {n} {shape}, line {line}: {program.lines[line - 1]}\n"
                                    f"  tip off by {off:.3g} mm, tool by {lean:.3g}; {event}\n{said}")
                    break
        failures += dialect_programs.check(isogloss, options.plugins, folder, Machine.of)
    for failure in failures[:5]:
        print(failure)
    print(f"{options.programs} programs, {checked} moves: tip within {worst_mm:.2g} mm, tool within "
          f"{worst_direction:.2g}; {len(failures)} programs fail")
    return 1 if failures or checked < 10 * options.programs else 0


if __name__ == "__main__":
    sys.exit(main())
