#!/usr/bin/env python3
"""Random chains of cycles 7, 8, 10, 11 and 247 and of tilted planes against plain matrices; presets are rotated, too.

  frames_test.py --isogloss PATH [--programs N] [--seed S]

The model follows the manual: the datum shift counts from the preset, or in the system that a mirror image, a rotation
or a scaling made before it; mirror image and rotation act about it in the order of their definition, a plane turns
about it, and a shift and a rotation in the plane act inside the plane. A scaling acts about the datum in force. On a
machine whose table A carries table C the workpiece turns with them. Every move must end where the model does, to 1e-6
mm; after TURN and MOVE the rotary axes must set the plane upright, and MOVE must leave the tip where it was in the
workpiece.
"""
import csv
import math
import pathlib
import random
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

import random_runs  # noqa: E402: it lies in another folder

PRESETS = {1: (10.0, -20.0, 30.5), 2: (-7.25, 3.0, -100.0), 3: (4.0, 5.0, -6.5), 4: (0.0, -1.0, 2.0)}
ROTATIONS = {3: (0.0, 0.0, 33.0), 4: (7.0, -12.0, 80.5)}  # SPA, SPB, SPC
LENGTH = 57.3
PIVOT_A, PIVOT_C = (0.0, 0.5, -90.0), (0.25, -0.75, -150.0)
UNIT = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
MACHINE = f"""<?xml version="1.0" encoding="UTF-8"?>
<Dependencies xmlns="urn:isogloss:dialect:1">
  <MachineAxes>
    <Axis name="X"/> <Axis name="Y"/> <Axis name="Z"/>
    <Axis name="A" Minimum="-185" Maximum="185" Rollover="0"/>
    <Axis name="C" Rollover="1"/>
  </MachineAxes>
  <MachineKinematics>
    <Axis name="A" Place="table" Order="1" PivotX="{PIVOT_A[0]}" PivotY="{PIVOT_A[1]}" PivotZ="{PIVOT_A[2]}"/>
    <Axis name="C" Place="table" Order="2" PivotX="{PIVOT_C[0]}" PivotY="{PIVOT_C[1]}" PivotZ="{PIVOT_C[2]}"/>
  </MachineKinematics>
</Dependencies>
"""


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def turned(m, v):
    return [sum(m[i][k] * v[k] for k in range(3)) for i in range(3)]


def back(m, v):
    """By the transpose: all matrices here keep lengths."""
    return [sum(m[k][i] * v[k] for k in range(3)) for i in range(3)]


def sized(v, factor):
    return [x * factor for x in v]


def plus(*vectors):
    return [sum(c) for c in zip(*vectors)]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def about(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    u, v = (axis + 1) % 3, (axis + 2) % 3
    m = [list(row) for row in UNIT]
    m[u][u], m[u][v], m[v][u], m[v][v] = c, -s, s, c
    return m


class Program:
    def __init__(self, seed, blocks=110):
        self.random = random.Random(seed)
        self.lines, self.checks = [], {}
        self.preset, self.shift = [0.0] * 3, [0.0] * 3
        self.basic = UNIT
        self.mirrored, self.angle, self.rotated_after_mirror = (False, False), 0.0, False
        self.turned_before, self.mirrored_before = False, False  # the shift came after them
        self.plane = None  # a matrix
        self.inner_shift, self.inner_angle, self.inner_turned_before = [0.0] * 3, 0.0, False
        self.scale, self.scaled_before, self.inner_scaled_before = 1.0, False, False
        self.write("BEGIN PGM CHAIN MM")
        self.write("TOOL CALL 1 Z S1000 F500")
        self.move(all_axes=True)
        steps = [(30, self.move), (6, self.arc), (6, self.datum), (3, self.datum_preset), (4, self.rotation), (4, self.mirror),
                 (4, self.scaling), (8, self.tilt), (3, self.machine_block), (3, self.reset)]
        for step in self.random.choices([s for _, s in steps], [w for w, _ in steps], k=blocks):
            step()
        self.write("M30")
        self.write("END PGM CHAIN MM")

    def write(self, text):
        self.lines.append(f"{len(self.lines)} {text}")

    def check(self, what, *values):
        self.checks[len(self.lines)] = (what, *values)

    def value(self, low=-80, high=80):
        return round(self.random.uniform(low, high), 3)

    def is_plain(self):
        return self.plane is None and not any(self.mirrored) and self.angle == 0

    def matrix(self):
        if self.plane is not None:
            return times(self.plane, about(2, self.inner_angle))
        flip = [[-1.0 if i == j and i < 2 and self.mirrored[i] else UNIT[i][j] for j in range(3)] for i in range(3)]
        turn = about(2, self.angle)
        return times(flip, turn) if self.rotated_after_mirror else times(turn, flip)

    def way(self):
        """The shift along the axes of the preset."""
        v = sized(self.shift, self.scale if self.scaled_before else 1)
        v = [-x if i < 2 and self.mirrored[i] and self.mirrored_before else x for i, x in enumerate(v)]
        if not self.turned_before:
            return v
        is_reversed = self.rotated_after_mirror and sum(self.mirrored) == 1
        return turned(about(2, -self.angle if is_reversed else self.angle), v)

    def frame(self):
        """How the program's axes lie, where its zero is, and how long one of its millimetres is."""
        origin = self.way()
        if self.plane is not None:
            v = sized(self.inner_shift, self.scale if self.inner_scaled_before else 1)
            if self.inner_turned_before:
                v = turned(about(2, self.inner_angle), v)
            origin = plus(origin, turned(self.plane, v))
        return times(self.basic, self.matrix()), plus(self.preset, turned(self.basic, origin)), self.scale

    # ---- steps

    def move(self, all_axes=False):
        words = {a: (self.random.random() < 0.3 and not all_axes, self.value())
                 for a in self.random.sample(range(3), 3 if all_axes else self.random.randint(1, 3))}
        text = " ".join(("I" if step else "") + "XYZ"[a] + f"{v:+.3f}" for a, (step, v) in words.items())
        self.write(f"L {text} R0 {self.random.choice(('FMAX', 'F300', ''))}".rstrip())
        self.check("move", words, self.frame())

    def arc(self):
        radius, begin = self.random.uniform(2, 40), self.random.uniform(0, 360)
        sweep = self.random.uniform(10, 700) * self.random.choice((-1, 1))
        centre = [self.value(), self.value(), self.value()]
        point = lambda degrees: [centre[0] + radius * math.cos(math.radians(degrees)),
                                 centre[1] + radius * math.sin(math.radians(degrees))]
        x, y = point(begin)
        self.write(f"L X{x:+.9f} Y{y:+.9f} Z{centre[2]:+.9f} FMAX")
        self.check("move", {0: (False, x), 1: (False, y), 2: (False, centre[2])}, self.frame())
        self.write(f"CC X{centre[0]:+.9f} Y{centre[1]:+.9f}")
        sense = "DR+" if sweep > 0 else "DR-"
        x, y = point(begin + sweep)
        height = self.value(-20, 20)
        if self.random.random() < 0.5:
            self.write(f"CP IPA{sweep:+.9f} IZ{height:+.3f} {sense} F200")
        else:
            sweep = math.copysign(abs(sweep) % 360, sweep)
            height = 0.0
            self.write(f"C X{x:+.9f} Y{y:+.9f} {sense} F200")
        self.check("arc", {0: (False, x), 1: (False, y), 2: (True, height)}, self.frame(), centre, sweep)

    def datum(self):
        if self.plane is not None:
            shift = self.inner_shift
            if not any(shift):
                self.inner_turned_before, self.inner_scaled_before = self.inner_angle != 0, self.scale != 1
        else:
            shift = self.shift
            if not any(shift):
                self.turned_before, self.mirrored_before = self.angle != 0, any(self.mirrored)
                self.scaled_before = self.scale != 1
        self.write("CYCL DEF 7.0 DATUM SHIFT")
        for part, axis in enumerate(self.random.sample(range(3), self.random.randint(1, 3)), 1):
            step, v = self.random.random() < 0.3, self.value()
            self.write(f"CYCL DEF 7.{part} {'I' if step else ''}{'XYZ'[axis]}{v:+.3f}")
            shift[axis] = shift[axis] + v if step else v

    def datum_preset(self):
        if not self.is_plain():
            return
        row = self.random.choice(list(PRESETS))
        self.write(f"CYCL DEF 247 DATUM SETTING Q339={row:+d}")
        self.preset, self.shift = list(PRESETS[row]), [0.0] * 3
        a, b, c = ROTATIONS.get(row, (0.0, 0.0, 0.0))
        self.basic = times(times(about(2, c), about(1, b)), about(0, a))
        self.turned_before, self.mirrored_before = False, False
        self.scaled_to(1.0)

    def scaled_to(self, factor):
        self.scale = factor
        if factor == 1:
            self.scaled_before, self.inner_scaled_before = False, False

    def scaling(self):
        factor = self.random.choice((1.0, round(self.random.uniform(0.3, 3), 6)))
        kind = self.random.choice(("cycle", "SCL", "RESET"))
        if kind == "cycle":
            self.write("CYCL DEF 11.0 SCALING")
            self.write(f"CYCL DEF 11.1 SCL {factor:.6f}")
        elif kind == "SCL":
            self.write(f"TRANS SCALE SCL{factor:.6f}")
        else:
            factor = 1.0
            self.write("TRANS SCALE RESET")
        self.scaled_to(factor)

    def rotation(self):
        in_plane = self.plane is not None
        step = self.random.random() < 0.3 and (self.inner_angle if in_plane else self.angle) != 0 and not any(self.mirrored)
        v = self.value(-180, 180)
        self.write("CYCL DEF 10.0 ROTATION")
        self.write(f"CYCL DEF 10.1 {'I' if step else ''}ROT{v:+.3f}")
        if in_plane:
            self.inner_angle = self.inner_angle + v if step else v
            return
        if not step:
            self.rotated_after_mirror = any(self.mirrored)
        self.angle = self.angle + v if step else v

    def mirror(self):
        if self.plane is not None or (self.angle != 0 and self.rotated_after_mirror):
            return
        axes = self.random.sample("XY", self.random.randint(0, 2))
        self.write("CYCL DEF 8.0 MIRROR IMAGE")
        self.write("CYCL DEF 8.1 " + " ".join(axes))
        self.mirrored = ("X" in axes, "Y" in axes)
        self.mirrored_before = self.mirrored_before and any(self.mirrored)
        self.rotated_after_mirror = False

    def tilt(self):
        if self.plane is None and not self.is_plain():
            return
        self.reset_plane()
        if self.plane is not None and self.random.random() < 0.4:
            self.end_plane()
            return
        a, b, c = (self.value(-60, 60) for _ in range(3))
        kind = self.random.choice(("SPATIAL", "EULER", "VECTOR", "RELATIV"))
        if kind == "SPATIAL":
            m, words = times(times(about(2, c), about(1, b)), about(0, a)), f"SPA{a:+} SPB{b:+} SPC{c:+}"
        elif kind == "EULER":
            m, words = times(times(about(2, a), about(0, b)), about(2, c)), f"EULPR{a:+} EULNU{b:+} EULROT{c:+}"
        elif kind == "RELATIV":
            axis = self.random.randrange(3)
            m, words = times(self.plane or UNIT, about(axis, a)), f"SP{'ABC'[axis]}{a:+}"
        else:
            m = times(times(about(2, c), about(1, b)), about(0, a))
            base, normal = ([row[k] for row in m] for k in (0, 2))
            words = " ".join(f"B{x}{v:+.12f}" for x, v in zip("XYZ", base))
            words += " " + " ".join(f"N{x}{v:+.12f}" for x, v in zip("XYZ", normal))
        how = self.random.choice(("STAY", "TURN FMAX", "TURN F1000", "MOVE DIST0 F1000"))
        way = self.random.choice(("", " SEQ+", " SEQ-"))
        self.plane = m
        self.write(f"PLANE {kind} {words} {how}{way}")
        self.check("turn" if how != "STAY" else "stay", how, way, self.frame())

    def reset_plane(self):
        """In the reverse order: rotation, shift. Without a shift in the plane the zero is that from before it."""
        if self.inner_angle != 0:
            self.write("CYCL DEF 10.0 ROTATION")
            self.write("CYCL DEF 10.1 ROT+0")
        if any(self.inner_shift):
            self.write("CYCL DEF 7.0 DATUM SHIFT")
            for part, axis in enumerate("XYZ", 1):
                self.write(f"CYCL DEF 7.{part} {axis}+0")
        self.inner_shift, self.inner_angle, self.inner_turned_before = [0.0] * 3, 0.0, False
        self.inner_scaled_before = False

    def end_plane(self):
        self.reset_plane()
        self.plane = None
        self.write(self.random.choice(("PLANE RESET STAY", "PLANE RESET TURN FMAX")))
        self.check("end")

    def machine_block(self):
        words = {a: self.value() for a in self.random.sample(range(3), self.random.randint(1, 3))}
        self.write("L " + " ".join("XYZ"[a] + f"{v:+.3f}" for a, v in words.items()) + " FMAX M91")
        self.check("machine", words)

    def reset(self):
        if self.plane is not None:
            self.end_plane()
        for cycle, text in ((10, "ROT+0"), (8, ""), (7, "X+0 Y+0 Z+0")):
            self.write(f"CYCL DEF {cycle}.0 RESET")
            for part, word in enumerate(text.split() or [""], 1):
                self.write(f"CYCL DEF {cycle}.{part} {word}".rstrip())
        self.mirrored, self.angle, self.rotated_after_mirror = (False, False), 0.0, False
        self.shift, self.turned_before, self.mirrored_before = [0.0] * 3, False, False
        self.scaled_before = False


class Machine:
    """Where the axes stand; `turn` follows the table to its angles as the run shows them."""

    def __init__(self):
        self.at, self.a, self.c = [0.0] * 3, 0.0, 0.0
        self.is_led = False  # the frame stands with the table

    def table(self, p):
        p = plus(PIVOT_C, turned(about(2, -self.c), minus(p, PIVOT_C)))
        return plus(PIVOT_A, turned(about(0, -self.a), minus(p, PIVOT_A)))

    def from_table(self, p):
        p = plus(PIVOT_A, turned(about(0, self.a), minus(p, PIVOT_A)))
        return plus(PIVOT_C, turned(about(2, self.c), minus(p, PIVOT_C)))

    def program(self, frame):
        p = minus(self.at, [0.0, 0.0, LENGTH])
        if self.is_led:
            p = self.from_table(p)
        return sized(back(frame[0], minus(p, frame[1])), 1 / frame[2])

    def machine(self, frame, p):
        p = plus(turned(frame[0], sized(p, frame[2])), frame[1])
        if self.is_led:
            p = self.table(p)
        return plus(p, [0.0, 0.0, LENGTH])


def step(machine, check, row):
    """How the row differs from the check, or None."""
    got = [float(row[c]) for c in ("mx", "my", "mz")] if row else list(machine.at)
    angles = [float(row[c] or 0) for c in "ac"] if row else [machine.a, machine.c]
    what = check[0]
    if what in ("move", "arc"):
        _, words, frame = check[:3]
        target = machine.program(frame)
        for axis, (is_step, v) in words.items():
            target[axis] = target[axis] + v if is_step else v
        wanted = machine.machine(frame, target)
    elif what == "machine":
        wanted = list(machine.at)
        for axis, v in check[1].items():
            wanted[axis] = v
    elif what == "stay":
        machine.is_led = True
        wanted = list(machine.at)
    elif what == "end":
        machine.a, machine.c = angles
        machine.is_led = False
        wanted = list(machine.at)
    else:
        _, how, way, frame = check
        tip = machine.from_table(minus(machine.at, [0.0, 0.0, LENGTH]))
        machine.a, machine.c = angles
        machine.is_led = True
        normal = turned(about(0, -machine.a), turned(about(2, -machine.c), [r[2] for r in frame[0]]))
        if math.dist(normal, [0, 0, 1]) > 1e-9:
            return f"the plane does not stand upright at A{machine.a} C{machine.c}"
        if way and machine.a and (machine.a > 0) != (way == " SEQ+"):
            return f"A{machine.a} under{way}"
        wanted = plus(machine.table(tip), [0.0, 0.0, LENGTH]) if how.startswith("MOVE") else list(machine.at)
    if row is None and math.dist(wanted, machine.at) > 1e-6:
        return f"no move, {wanted} expected"
    if math.dist(wanted, got) > 1e-6:
        return f"{got} instead of {wanted}"
    machine.at = wanted
    if what == "arc":
        if row["event"] != "arc":
            return "no arc"
        wanted = machine.machine(check[2], check[3])
        if math.dist(wanted, [float(row[c]) for c in ("mcx", "mcy", "mcz")]) > 1e-6:
            return f"another centre than {wanted}"
        if abs(abs(float(row["sweep"])) - abs(check[4])) > 1e-5:
            return f"{row['sweep']} degrees instead of {check[4]}"
    return None


def difference(isogloss, folder, program):
    (folder / "in.h").write_text("\n".join(program.lines) + "\n")
    (folder / "machine.xml").write_text(MACHINE)
    settings = [w for n, xyz in PRESETS.items() for a, v in zip("XYZ", xyz)
                for w in ("--set", f"IsoCoordinateTable.DATUM_PRESET_{n}.{a}={v}")]
    settings += [w for n, angles in ROTATIONS.items() for a, v in zip("ABC", angles)
                 for w in ("--set", f"HeidenhainBasicRotations.{n}.SP{a}={v}")]
    run = subprocess.run([isogloss, "run", "in.h", "-d", "heidenhain", "--checked", "--machine", "machine.xml",
                          "--emit", "motions", "--format", "csv", "--exact", "--set", f"ToolOffsetTable.1.H={LENGTH}", *settings],
                         cwd=folder, capture_output=True, text=True, timeout=60, check=False)
    if run.returncode != 0:
        return 0, f"isogloss ends with {run.returncode}: {run.stderr[:600]}"
    rows = {int(row["line"]): row for row in csv.DictReader(run.stdout.splitlines())
            if row["event"] in ("rapid", "feed", "arc")}
    machine = Machine()
    for line, check in sorted(program.checks.items()):
        report = step(machine, check, rows.get(line))
        if report:
            return line, f"line {line}, {program.lines[line - 1]}: {report}"
    return len(program.checks), None


if __name__ == "__main__":
    sys.exit(random_runs.run(__doc__, Program, difference, ".h"))
