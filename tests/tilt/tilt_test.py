#!/usr/bin/env python3
"""Random programs of tilted planes against a model of a few formulas.

  tilt_test.py --isogloss PATH [--programs N] [--seed S] [--keep DIR]

A point of the program lies at origin + R point in the work offset, R has X', Y' and Z' as its columns. G52, the work
offset and the tool length are added to it. Every move of `isogloss run`, in both dialects, must end at the computed
point, to 1e-9 mm; and the arcs must have their centre and their normal there.
"""
import csv
import math
import pathlib
import random
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

import random_runs  # noqa: E402: it lies in another folder

LENGTHS = {1: 100.0, 2: 57.3}
WORK = {"G54": [10.5, -20.25, 30.125], "G55": [-200.0, 100.0, -50.0]}
WORDS = "XYZ"


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def unit(a):
    return [x / math.sqrt(dot(a, a)) for x in a]


def plus(*vectors):
    return [sum(c) for c in zip(*vectors)]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def rotated(axis, degrees, v):
    """The vector turned about an axis through 0 (Rodrigues)."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    along = dot(axis, v) * (1 - c)
    return plus([c * x for x in v], [s * x for x in cross(axis, v)], [along * x for x in axis])


X, Y, Z = [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]


class Plane:
    """An origin and three axes, each a vector of the system around it."""

    def __init__(self, origin=(0.0, 0.0, 0.0), axes=(X, Y, Z)):
        self.origin, self.axes = list(origin), [list(a) for a in axes]

    def way(self, v):
        return plus(*([c * x for x in axis] for c, axis in zip(v, self.axes)))

    def out(self, point):
        return plus(self.origin, self.way(point))

    def into(self, point):
        return [dot(axis, minus(point, self.origin)) for axis in self.axes]

    def inside(self, outer):
        return Plane(outer.out(self.origin), [outer.way(a) for a in self.axes])

    def turned(self, degrees):
        """Turned in itself, about Z'."""
        x, y, z = self.axes
        return Plane(self.origin, [rotated(z, degrees, x), rotated(z, degrees, y), z])


def by_euler(origin, i, j, k):
    x, y, z = (rotated(Z, i, a) for a in (X, Y, Z))
    y, z = rotated(x, j, y), rotated(x, j, z)
    return Plane(origin, [x, y, z]).turned(k)


def by_turns(origin, angles, order, along):
    """Roll, pitch, yaw about axes at rest, or about axes that turn along."""
    axes = [X, Y, Z]
    for digit in order:
        which = int(digit) - 1
        axis = axes[which] if along else [X, Y, Z][which]
        axes = [rotated(axis, angles[which], a) for a in axes]
    return Plane(origin, axes)


def by_points(first, second, third):
    x = unit(minus(second, first))
    z = unit(cross(x, minus(third, first)))
    return Plane(first, [x, cross(z, x), z])


def by_vectors(origin, x, z):
    z = unit(z)
    x = unit(minus(x, [dot(x, z) * c for c in z]))
    return Plane(origin, [x, cross(z, x), z])


def by_projections(origin, i, j, k):
    a, b = rotated(Y, i, X), rotated(X, j, Y)
    z = unit(cross(a, b))
    return Plane(origin, [a, cross(z, a), z]).turned(k)


class Program:
    """Random blocks and, by line, the machine coordinates that they end at; of arcs their centre and normal too."""

    def __init__(self, seed, rules, blocks=120):
        self.random = random.Random(f"{seed} {rules}")
        self.rules, self.turns_along = rules, rules == "turned.xml"
        self.lines, self.ends, self.arcs = [], {}, {}
        self.at = self.here = [0.0] * 3
        self.plane, self.tilts = Plane(), False
        self.work, self.local, self.length = WORK["G54"], [0.0] * 3, 0.0
        self.incremental = False
        self.write("G90 G54 G17 G21 G49 G69")
        self.rest()
        steps = [(30, self.move), (12, self.arc), (12, self.define), (5, self.nest), (4, self.end), (4, self.shift),
                 (3, self.select), (3, self.compensate), (3, self.distance)]
        for step in self.random.choices([s for _, s in steps], [w for w, _ in steps], k=blocks):
            step()
        self.write("M30")

    def write(self, text):
        self.lines.append(text)

    def value(self, low=-100, high=100):
        return round(self.random.uniform(low, high), 3)

    def point(self):
        return [self.value() for _ in range(3)]

    @staticmethod
    def text(values, letters=WORDS):
        return " ".join(f"{a}{v:.3f}" for a, v in zip(letters, values))

    def offsets(self):
        follows = self.tilts and self.rules == "iso"
        return plus(self.work, self.local, [self.length * c for c in (self.plane.axes[2] if follows else Z)])

    def machine(self, point):
        return plus(self.plane.out(point), self.offsets())

    def rest(self):
        """The frame has changed under the resting tool: it stands at another point of the program, known to 1e-9."""
        self.here = [round(c, 9) for c in self.plane.into(minus(self.at, self.offsets()))]

    def go(self, target):
        self.here, self.at = target, self.machine(target)
        self.ends[len(self.lines)] = list(self.at)

    def move(self):
        words = {a: self.value() for a in self.random.sample(range(3), self.random.randint(1, 3))}
        code = self.random.choice(("G00", "G01 F500"))
        self.write(f"{code} " + " ".join(f"{WORDS[a]}{v:.3f}" for a, v in words.items()))
        target = list(self.here)
        for axis, v in words.items():
            target[axis] = target[axis] + v if self.incremental else v
        self.go(target)

    def arc(self):
        first, second, tool, code = self.random.choice([(0, 1, 2, "G17"), (2, 0, 1, "G18"), (1, 2, 0, "G19")])
        start = self.here
        angle, sweep = math.radians(self.value(-180, 180)), math.radians(self.value(10, 350))
        radius = self.value(5, 50)
        clockwise = self.random.random() < 0.5
        i, j = round(-radius * math.cos(angle), 3), round(-radius * math.sin(angle), 3)
        centre = list(start)
        centre[first] += i
        centre[second] += j
        turned = -sweep if clockwise else sweep
        c, s = math.cos(turned), math.sin(turned)
        end = list(start)
        words = {}
        for axis, way in ((first, -c * i + s * j), (second, -s * i - c * j)):
            base = start[axis] if self.incremental else 0.0
            words[axis] = round(centre[axis] + way - base, 7)
            end[axis] = base + words[axis]
        end_words = f"{WORDS[first]}{words[first]:.7f} {WORDS[second]}{words[second]:.7f}"
        centre_words = f"{'IJK'[first]}{i:.3f} {'IJK'[second]}{j:.3f}"
        self.write(f"{code} {'G02' if clockwise else 'G03'} {end_words} {centre_words} F500")
        self.go(end)
        self.arcs[len(self.lines)] = self.machine(centre), self.plane.axes[tool], math.degrees(turned)
        self.write("G17 G00")

    def definition(self, code):
        """Blocks of a plane, and the plane."""
        origin = self.point()
        angles = [self.random.choice((self.value(-180, 180), 90.0, -90.0, 0.0)) for _ in range(3)]
        way = self.random.randrange(5)
        if way == 0:
            return [f"{code} {self.text(origin)} {self.text(angles, 'IJK')}"], by_euler(origin, *angles)
        if way == 1:
            order = self.random.choice(("123", "132", "213", "231", "312", "321"))
            return ([f"{code} P1 Q{order} {self.text(origin)} {self.text(angles, 'IJK')}"],
                    by_turns(origin, angles, order, self.turns_along))
        if way == 2:
            points = [self.point() for _ in range(3)]
            plane = by_points(*points)
            blocks = [f"{code} P2 Q{q} {self.text(p)}" for q, p in enumerate(points, 1)]
            self.random.shuffle(blocks)
            if self.random.random() < 0.5:
                shift, turn = self.point(), self.value(-180, 180)
                blocks.insert(self.random.randrange(3), f"{code} P2 Q0 {self.text(shift)} R{turn:.3f}")
                plane = Plane(plane.out(shift), plane.axes).turned(turn)
            return blocks, plane
        if way == 3:
            z = unit(self.point())
            x = unit(cross(z, self.point()))
            z, x = [round(c * 80, 3) for c in z], [round(c * 30, 3) for c in plus(x, [0.05 * c for c in z])]
            blocks = [f"{code} P3 Q1 {self.text(origin)} {self.text(x, 'IJK')}", f"{code} P3 Q2 {self.text(z, 'IJK')}"]
            self.random.shuffle(blocks)
            return blocks, by_vectors(origin, x, z)
        angles = [self.value(-80, 80), self.value(-80, 80), angles[2]]
        return [f"{code} P4 {self.text(origin)} {self.text(angles, 'IJK')}"], by_projections(origin, *angles)

    def define(self):
        blocks, plane = self.definition("G68.2")
        for block in blocks:
            self.write(block)
        self.plane, self.tilts = plane, True
        self.rest()

    def nest(self):
        if not self.tilts:
            return
        blocks, plane = self.definition("G68.4")
        for block in blocks:
            self.write(block)
        self.plane = plane.inside(self.plane)
        self.rest()

    def end(self):
        self.write("G69")
        self.plane, self.tilts = Plane(), False
        self.rest()

    def shift(self):
        self.local = self.point()
        self.write("G52 " + self.text(self.local))
        self.rest()

    def select(self):
        code = self.random.choice(list(WORK))
        self.write(code)
        self.work = WORK[code]
        self.rest()

    def compensate(self):
        if self.incremental:
            return
        row = self.random.choice(list(LENGTHS))
        self.length = LENGTHS[row]
        self.write(f"G43 H{row}")
        self.rest()
        self.write("Z0.")  # before any increment: the fanuc dialect travels the length
        self.go([self.here[0], self.here[1], 0.0])

    def distance(self):
        self.incremental = not self.incremental
        self.write("G91" if self.incremental else "G90")


TURNED = """<?xml version="1.0" encoding="UTF-8"?>
<Dialect xmlns="urn:isogloss:dialect:1" name="turned" title="Axes that turn along" extends="fanuc">
  <Chain>
    <Configure syntax="IsoG68p2TiltSyntax" roll-pitch-yaw="turned"/>
  </Chain>
</Dialect>
"""


def difference(isogloss, folder, program):
    """(moves compared, how the first different one differs, or None)"""
    (folder / "in.nc").write_text("\n".join(program.lines) + "\n")
    (folder / "turned.xml").write_text(TURNED)
    settings = [w for row, mm in LENGTHS.items() for w in ("--set", f"ToolOffsetTable.{row}.H={mm}")]
    settings += [w for code, offset in WORK.items() for a, mm in zip(WORDS, offset)
                 for w in ("--set", f"IsoCoordinateTable.{code}.{a}={mm}")]
    run = subprocess.run([isogloss, "run", "in.nc", "-d", program.rules, "--emit", "motions", "--format", "csv", "--exact",
                          "--zero-moves", *settings], cwd=folder, capture_output=True, text=True, timeout=60, check=False)
    if run.returncode != 0:
        return 0, f"isogloss ends with {run.returncode}: {run.stderr[:600]}"
    rows = {int(row["line"]): row for row in csv.DictReader(run.stdout.splitlines())
            if row["event"] in ("rapid", "feed", "arc")}
    if rows.keys() != program.ends.keys():
        return 0, f"lines that move: {sorted(rows.keys() ^ program.ends.keys())}"
    for count, (line, wanted) in enumerate(sorted(program.ends.items())):
        def numbers(*columns):
            return [float(rows[line][c]) for c in columns]
        near = 1e-6 if line in program.arcs else 1e-9  # ends of arcs are written with 7 decimals: their sweep differs
        off = math.dist(wanted, numbers("mx", "my", "mz"))
        if line in program.arcs:
            centre, normal, sweep = program.arcs[line]
            off = max(off, math.dist(centre, numbers("mcx", "mcy", "mcz")), abs(sweep - numbers("sweep")[0]) / 10,
                      math.dist(normal, numbers("nx", "ny", "nz")))
        if off > near * max(1.0, max(map(abs, wanted)) / 1000):
            is_ = numbers("mx", "my", "mz")
            return count, f"line {line}, {program.lines[line - 1]}: {is_}, {off} from {wanted} {program.arcs.get(line, '')}"
    return len(rows), None


if __name__ == "__main__":
    sys.exit(random_runs.run(__doc__, Program, difference, ".nc", ("iso", "fanuc", "turned.xml"), 20))
