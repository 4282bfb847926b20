#!/usr/bin/env python3
"""Random five-axis programs in Klartext, for SINUMERIK and for Fanuc, on random machines with limits.

  dialect_test.py --isogloss PATH [--programs N] [--seed S] [--keep DIR]

Each program is generated together with what the manuals demand: where the tip stands in the workpiece, where the rotary
axes stand, and which of two solutions is selected. The model knows the description of the machine alone
(tip_test.Machine, rotary_solver). Every block of `isogloss run` must end there, to 1e-6 mm and degrees, and must show
that program point.
"""
import argparse
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import budgeted  # noqa: E402: it lies in another folder

from rotary_solver import INFINITE, Unclear, cross, inside, least, turn_inside  # noqa: E402
from tip_test import MACHINES, Machine, inner, minus, plus, times, turned  # noqa: E402

SHAPES = MACHINES + [[("C", "table", None)], [("A", "head", None)]]
AXES = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0])
LEVEL = ([0.0, 0.0, 0.0], *AXES)


def unit(v):
    return times(1 / math.sqrt(inner(v, v)), v)


def crooked(rng, machine):
    """Axes as measured: off by some degrees."""
    machine.axes = [(a, place, unit(plus(n, [rng.uniform(-0.05, 0.05) for _ in range(3)])), p)
                    for a, place, n, p in machine.axes]


def along(plane, v):
    return plus(*(times(c, axis) for c, axis in zip(v, plane[1:])))


def out_of(plane, p):
    return plus(plane[0], along(plane, p))


def into(plane, p):
    away = minus(p, plane[0])
    return [inner(away, axis) for axis in plane[1:]]


def turned_axes(turns):
    """The directions of a plane: each turn about an axis that rests, one after the other."""
    axes = AXES
    for n, degrees in turns:
        axes = tuple(turned(a, n, degrees) for a in axes)
    return axes


class Failed(Exception):
    """The control stops here."""


class Program:
    """Blocks, and what each is to do: `goals` holds, by line, the tip, the angles and the program point."""

    dialect = extension = ""
    counts_on = False  # angles are more than places of the circle

    def __init__(self, rng, shape):
        self.rng = rng
        self.machine = Machine(rng, shape)
        if len(shape) == 2 and rng.random() < 0.3:
            crooked(rng, self.machine)
        self.letters = self.machine.letters
        self.travel = {a: self.some_travel(self.machine.zeros[a]) for a in self.letters}
        self.angles = {a: 0.0 for a in self.letters}
        self.xyz = [0.0, 0.0, 0.0]
        self.length = 0.0
        self.own_length = self.number(40, 150)
        self.work = [self.number(-80, 80) for _ in range(3)]
        self.shift = {a: rng.choice([0.0, 0.0, self.number(-30, 30)]) for a in self.letters}
        self.frames = [LEVEL]  # from the workpiece to the program
        self.lines, self.goals, self.fails, self.ways, self.led = [], {}, {}, {}, {}
        try:
            self.make()
        except Failed:
            pass
        self.end()

    def some_travel(self, zero):
        kind = self.rng.randrange(4)
        if kind < 2:
            return INFINITE
        low = min(0.0, zero) - self.rng.choice([5, 40, 95, 120, 200])
        high = max(0.0, zero) + self.rng.choice([5, 40, 95, 120, 200, 400])
        return low, high

    def number(self, low, high):
        return round(self.rng.uniform(low, high), 3)

    def chance(self, share):
        return self.rng.random() < share

    def some_point(self):
        return [self.number(-60, 60) for _ in range(3)]

    def write(self, text):
        self.lines.append(text)
        return len(self.lines)

    # ---- where the tool stands

    def to_workpiece(self, p):
        for frame in reversed(self.frames):
            p = out_of(frame, p)
        return plus(self.work, p)

    @property
    def point(self):
        tip = self.machine.tip(self.xyz, self.angles, self.length)
        p = minus(self.machine.in_workpiece(tip, self.angles), self.work)
        for frame in self.frames:
            p = into(frame, p)
        return p

    def tip_to(self, p, angles=None):
        """The tip goes to a point of the program, the axes to their angles."""
        wanted = self.to_workpiece(p)
        self.angles = dict(angles or self.angles)
        self.xyz = minus(self.machine.part(wanted, self.angles),
                         self.machine.hanging([0.0, 0.0, -self.length], self.angles))

    def plain_to(self, p):
        """No tip control, no plane: X Y Z are independent of the rotary axes."""
        self.xyz = plus(self.work, p, [0.0, 0.0, self.length])

    def expect(self, line, shows_point=True, led=None):
        """`led`: the tip goes straight in the workpiece while the axes turn."""
        self.goals[line] = (list(self.xyz), dict(self.angles), self.point if shows_point else None)
        if led is not None:
            self.led[line] = led

    # ---- angles

    def some_angle(self, letter, present=None, step=None):
        low, high = self.travel[letter]
        if step is not None:
            if self.travel[letter] == INFINITE and self.chance(0.2):
                step = 400  # more than half a turn
            for _ in range(20):
                to = present + self.number(-step, step)
                if low <= to <= high:
                    return to
            return None
        return self.number(max(low, -170), min(high, 170))

    def some_plane_axes(self):
        if len(self.letters) == 1 and self.chance(0.8):  # a plane that the axis reaches
            return [self.number(-80, 80) if self.letters == [a] else 0.0 for a in "ABC"]
        angles = [self.rng.choice([0.0, 0.0, 90.0, -90.0, self.number(-80, 80), self.number(-80, 80)])
                  for _ in range(2)] + [self.rng.choice([0.0, self.number(-180, 180)])]
        return angles

    def fail(self, line, *codes):
        self.fails[line] = codes
        raise Failed

    def end(self):
        self.write("M30")

    def drawn(self, draw):
        """The first result of `draw` whose consequences the model knows."""
        for _ in range(50):
            try:
                return draw()
            except Unclear:
                continue
        raise Unclear


class Klartext(Program):
    dialect, extension = "heidenhain", "h"

    def tables(self):
        values = " ".join(f'{a}="{c!r}"' for a, c in [*zip("XYZ", self.preset), *self.shift.items()])
        return (f'<ToolOffsetTable><Tool id="1" H="{self.own_length!r}"/></ToolOffsetTable>'
                f'<IsoCoordinateTable><Offset id="DATUM_PRESET_3" {values}/></IsoCoordinateTable>')

    def end(self):
        self.write("END PGM T MM")

    def make(self):
        self.preset = list(self.work)
        self.write("BEGIN PGM T MM")
        self.write("CYCL DEF 247 Q339=+3")
        delta = self.rng.choice([0, 0, self.number(-2, 2)])
        self.write("TOOL CALL 1 Z S1000" + (f" DL{delta:+.3f}" if delta else ""))
        self.length = self.own_length + delta
        if self.chance(0.3):
            self.write("M126")
        # The axes begin where the model has them.
        self.plain_to(p := self.some_point())
        self.angles = {a: self.some_angle(a) for a in self.letters}
        self.expect(self.write("L " + self.words(p) + self.turns(self.letters) + " R0 FMAX"), False)
        for _ in range(self.rng.randint(2, 4)):
            self.rng.choice([self.tip_control, self.planes])()

    def words(self, p, axes=range(3)):
        return " ".join(f"{'XYZ'[a]}{p[a]:+.4f}" for a in axes)

    def turns(self, letters):
        return "".join(f" {a}{self.angles[a] - self.shift[a]:+.4f}" for a in letters)

    def move(self, leads):
        """A block with some of the words; without tip control X Y Z rest where only axes turn."""
        kind = self.rng.randrange(5)
        if kind == 0 or (kind == 1 and not leads):  # axes alone
            letter = self.rng.choice(self.letters)
            step = self.chance(0.5)
            to = self.some_angle(letter, self.angles[letter], 60) if step else self.some_angle(letter)
            if to is None:
                return
            way = round(to - self.angles[letter], 4)
            if step and self.travel[letter] == INFINITE and self.chance(0.1):
                way = self.rng.choice([360.0, -360.0])
            to = self.angles[letter] + way if step else round(to, 4)
            angles = {**self.angles, letter: to}
            of_machine = not step and self.chance(0.3)
            text = (f"L I{letter}{way:+.4f}" if step else
                    f"L {letter}{to - (0 if of_machine else self.shift[letter]):+.6f}")
            p = self.point
            if leads and not of_machine:
                self.tip_to(p, angles)
            else:
                self.angles = angles
            line = self.write(text + " F500" + (" M91" if of_machine else ""))
            turns = abs(way if step else math.remainder(way, 360)) > 1e-3
            self.expect(line, led=leads and not of_machine if turns else None)
            if step:
                self.ways[line] = {letter: way}
            return
        axes = [a for a in range(3) if self.chance(0.6)] or [0]
        p, angles, text, ways = self.point, dict(self.angles), "L", {}
        for a in axes:
            if self.chance(0.3):
                d = self.number(-20, 20)
                p[a] += d
                text += f" I{'XYZ'[a]}{d:+.3f}"
            else:
                p[a] = self.number(-60, 60)
                text += f" {'XYZ'[a]}{p[a]:+.3f}"
        if leads:
            for a in self.letters:
                if self.chance(0.4) and (to := self.some_angle(a, self.angles[a], 60)) is not None:
                    if self.chance(0.5):
                        way = round(to - angles[a], 4)
                        text += f" I{a}{way:+.4f}"
                        angles[a] += way
                        ways[a] = way
                    else:
                        angles[a] = round(to, 4)
                        text += f" {a}{angles[a] - self.shift[a]:+.4f}"
        self.tip_to(p, angles)
        line = self.write(text + self.rng.choice([" F800", " FMAX", " R0 F300"]))
        self.expect(line)
        self.ways[line] = ways

    def whole_move(self):
        p = [round(c, 4) for c in self.some_point()]
        self.tip_to(p)
        self.expect(self.write("L " + self.words(p) + " F800"))

    def tip_control(self):
        by_m = self.chance(0.6)
        self.write("M128" if by_m else "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS")
        frames = []
        if self.chance(0.3):
            shift = [self.number(-30, 30) for _ in range(3)]
            self.write("CYCL DEF 7.0 DATUM SHIFT")
            self.write("CYCL DEF 7.1 " + self.words(shift))
            frames.append((shift, *AXES))
        if self.chance(0.3):
            turn = self.number(-180, 180)
            self.write("CYCL DEF 10.0 ROTATION")
            self.write(f"CYCL DEF 10.1 ROT{turn:+.3f}")
            frames.append(([0.0] * 3, *turned_axes([(AXES[2], turn)])))
        self.frames = [LEVEL, *frames]
        self.whole_move()
        for _ in range(self.rng.randint(2, 8)):
            self.move(True)
            if self.chance(0.1):
                delta = self.number(-2, 2)
                self.write(f"TOOL CALL DL{delta:+.3f}")
                self.length = self.own_length + delta
                self.whole_move()
        if frames:
            self.write("CYCL DEF 10.0 ROTATION")
            self.write("CYCL DEF 10.1 ROT+0")
            self.write("CYCL DEF 7.0 DATUM SHIFT")
            self.write("CYCL DEF 7.1 X+0 Y+0 Z+0")
        self.frames = [LEVEL]
        self.write("M129" if by_m else "FUNCTION RESET TCPM")
        self.level()

    def level(self):
        """Without plane and tip control only the machine position is checked."""
        p = self.some_point()
        self.plain_to(p)
        self.expect(self.write("L " + self.words(p) + " R0 FMAX"), False)

    def some_plane(self, present):
        """Text, directions."""
        kind = self.rng.choice(["SPATIAL", "SPATIAL", "EULER", "VECTOR", "POINTS", "RELATIV", "AXIAL", "CYCLE"])
        a, b, c = self.some_plane_axes()
        x, y, z = AXES
        if kind == "CYCLE":
            return None, f"A{a:+.3f} B{b:+.3f} C{c:+.3f}", turned_axes([(x, a), (y, b), (z, c)]), None
        if kind == "AXIAL":
            if all(axis[1] == "head" for axis in self.machine.axes):
                raise Unclear  # HEI-0171
            angles = {letter: round(self.some_angle(letter), 3) for letter in self.letters}
            words = " ".join(f"{n}{v - self.shift[n]:+.3f}" for n, v in angles.items())
            axes = AXES
            for letter, place, n, _ in self.machine.axes[::-1]:
                if place == "head":
                    axes = tuple(turned(v, n, self.machine.geometric(letter, angles)) for v in axes)
            for letter, place, n, _ in self.machine.axes:
                if place == "table":
                    axes = tuple(turned(v, n, self.machine.geometric(letter, angles)) for v in axes)
            return kind, words, axes, angles
        if kind == "SPATIAL":
            return kind, f"SPA{a:+.3f} SPB{b:+.3f} SPC{c:+.3f}", turned_axes([(x, a), (y, b), (z, c)]), None
        if kind == "EULER":
            axes = turned_axes([(z, c), (x, b), (z, a)])
            return kind, f"EULPR{a:+.3f} EULNUT{b:+.3f} EULROT{c:+.3f}", axes, None
        if kind == "RELATIV":
            letter, n = self.rng.choice([("A", x), ("B", y), ("C", z)])
            own = turned_axes([(n, a)])
            return kind, f"SP{letter}{a:+.3f}", tuple(along((None, *present), v) for v in own), None
        normal = along((None, *turned_axes([(x, a), (y, b), (z, c)])), z)
        base = unit([self.rng.gauss(0, 1) for _ in range(3)])
        if kind == "VECTOR":
            normal, base = [round(v, 6) for v in normal], [round(v, 6) for v in base]
            n = unit(normal)
            if abs(inner(n, base)) > 0.9:
                raise Unclear
            bx = unit(minus(base, times(inner(base, n), n)))
            return (kind, " ".join(f"{w}{v:+.6f}" for w, v in zip(("BX", "BY", "BZ", "NX", "NY", "NZ"), [*base, *normal])),
                    (bx, cross(n, bx), n), None)
        points = [[round(v, 4) for v in self.some_point()] for _ in range(3)]
        first, third = minus(points[1], points[0]), minus(points[2], points[0])
        n = cross(first, third)
        if inner(n, n) < 1e5:
            raise Unclear
        n, px = unit(n), unit(first)
        words = " ".join(f"P{i + 1}{'XYZ'[k]}{points[i][k]:+.4f}" for i in range(3) for k in range(3))
        return kind, words, (px, cross(n, px), n), None

    def choose(self, normal, sign):
        head_is_second = len(self.letters) == 2 and self.machine.axes[1][1] == "head"
        master = self.letters[1 if head_is_second else 0]
        found = inside(self.machine, normal, self.angles, self.travel, sign, master)
        return least(found, lambda pair: sum(abs(pair[a] - self.angles[a]) for a in pair))

    def has_free_table(self):
        """The last axis is a table that stands square to a tool along Z."""
        return (len(self.letters) == 2 and self.machine.axes[1][1] == "table" and
                self.machine.axes[1][2] == AXES[2] and abs(self.machine.axes[0][2][2]) < 0.9)

    def level_plane(self):
        """No angle of the table leans the tool: TABLE ROT turns X of the plane to X of the machine, else it goes to 0."""
        turn = self.number(-170, 170)
        rotation = self.rng.choice(["", " COORD ROT", " TABLE ROT"])
        first, table = self.letters
        tilt = turn_inside(self.machine.zeros[first], self.angles[first], self.travel[first])
        to = self.machine.zeros[table] + self.machine.signs[table] * turn if "TABLE" in rotation else 0.0
        free = turn_inside(to, self.angles[table], self.travel[table])
        upright = {first: tilt, table: self.angles[table] if free is None else free}
        words = f"SPA+0 SPB+0 SPC{turn:+.3f}"
        return "SPATIAL", words, turned_axes([(AXES[2], turn)]), upright if tilt is not None else None, rotation

    def planes(self):
        present = AXES
        for count in range(self.rng.randint(1, 3)):
            def draw():
                if self.has_free_table() and self.chance(0.25):
                    return self.level_plane()
                kind, words, axes, angles = self.some_plane(present)
                if kind is None and count:
                    raise Unclear  # cycle 19 keeps angles that it does not name; one is enough
                if all(abs(inner(a, b) - 1) < 1e-9 for a, b in zip(axes, AXES)):
                    raise Unclear
                sign = self.rng.choice([0, 0, 1, -1]) if kind not in (None, "AXIAL") else 0
                upright = angles or self.choose(axes[2], sign)
                return kind, words, axes, upright, {0: "", 1: " SEQ+", -1: " SEQ-"}[sign]
            kind, words, axes, upright, sequence = self.drawn(draw)
            way = self.rng.choice(["STAY", "TURN", "MOVE", "MOVE DIST"]) if kind else "STAY"
            lever = self.number(-200, 200) if way == "MOVE DIST" else 0.0
            positioned = way.split()[0] + (f" DIST{lever:+.3f}" if lever else "")
            if kind:
                line = self.write(f"PLANE {kind} {words} {positioned}" + ("" if way == "STAY" else " F2000") + sequence)
            else:
                self.write("CYCL DEF 19.0 WORKING PLANE")
                line = self.write("CYCL DEF 19.1 " + words)
            if upright is None:
                self.fail(line, "HEI-0176")
            self.frames = [([0.0] * 3, *axes)]
            present = axes
            if way == "TURN":
                self.angles = upright
                self.expect(line)
            elif way == "STAY":
                rest = self.chance(0.3)
                if not rest:
                    self.angles = upright
                    text = "".join(f" {a}+Q{120 + 'ABC'.index(a)}" for a in self.letters)
                    self.expect(self.write("L" + text + " FMAX"))
            else:
                rests = minus(self.resting_tip(), times(lever, self.machine.direction(self.angles)))
                self.angles = upright
                tip = plus(rests, times(lever, self.machine.direction(upright)))
                self.xyz = minus(self.machine.part(tip, upright),
                                 self.machine.hanging([0.0, 0.0, -self.length], upright))
                self.expect(line)
            self.whole_move()
            for _ in range(self.rng.randint(1, 4)):
                self.move(False)
            if self.chance(0.3):
                self.write("M128")
                self.whole_move()
                for _ in range(self.rng.randint(1, 4)):
                    self.move(True)
                self.write("M129")
                self.whole_move()
            if self.chance(0.3):
                shift = [self.number(-30, 30) for _ in range(3)]
                self.write("CYCL DEF 7.0 DATUM SHIFT")
                self.write("CYCL DEF 7.1 " + self.words(shift))
                self.frames.append((shift, *AXES))
                self.whole_move()
                self.write("CYCL DEF 7.0 DATUM SHIFT")
                self.write("CYCL DEF 7.1 X+0 Y+0 Z+0")
                self.frames.pop()
        self.frames = [LEVEL]
        if self.chance(0.5) and all(low <= 0 <= high for low, high in self.travel.values()):
            line = self.write("PLANE RESET TURN FMAX")
            self.angles = {a: 0.0 for a in self.letters}
            self.expect(line, False)
        else:
            self.write("PLANE RESET STAY")
        self.level()

    def resting_tip(self):
        return self.machine.in_workpiece(self.machine.tip(self.xyz, self.angles, self.length), self.angles)


class Sinumerik(Program):
    dialect, extension = "siemens", "mpf"
    counts_on = True

    def tables(self):
        values = " ".join(f'{a}="{c!r}"' for a, c in [*zip("XYZ", self.first[0]), *self.first[1].items()])
        other = " ".join(f'{a}="{c!r}"' for a, c in [*zip("XYZ", self.other[0]), *self.other[1].items()])
        return (f'<ToolOffsetTable><Tool id="1" H="{self.own_length!r}"/></ToolOffsetTable>'
                f'<SiemensCoordinateTable><Offset id="G54" {values}/><Offset id="G55" {other}/></SiemensCoordinateTable>')

    def make(self):
        self.other = [self.number(-80, 80) for _ in range(3)], {a: self.number(-20, 20) for a in self.letters}
        self.first = (self.work, self.shift)
        self.write("G17 G90 G710 G54")
        self.write("T1 D1")
        self.write("M6")
        self.length = self.own_length
        self.plain_to(p := self.some_point())
        self.angles = {a: self.some_angle(a) for a in self.letters}
        self.expect(self.write("G0 " + self.words(p) + "".join(
            f" {a}{self.angles[a] - self.shift[a]:.4f}" for a in self.letters)), False)
        for _ in range(self.rng.randint(2, 4)):
            self.rng.choice([self.tip_control, self.planes])()

    def words(self, p, axes=range(3)):
        return " ".join(f"{'XYZ'[a]}{p[a]:.4f}" for a in axes)

    def turn_word(self, letter, incremental, frameless):
        """Text and where the axis goes; None where the travel has no room."""
        present, shift = self.angles[letter], self.shift[letter]
        low, high = self.travel[letter]
        if frameless:
            shift = 0.0
        kind = self.rng.choice(["", "", "AC", "IC", "DC", "ACP", "ACN"])
        if kind == "IC" or (kind == "" and incremental):
            to = self.some_angle(letter, present, 60)
            if to is None:
                return None
            way = round(to - present, 4)
            return (f" {letter}=IC({way})" if kind else f" {letter}{way:.4f}"), present + way
        if kind in ("", "AC"):
            to = round(self.some_angle(letter), 4)
            word = round(to - shift, 6)
            return (f" {letter}=AC({word})" if kind else f" {letter}{word:.6f}"), to
        word = self.number(0, 359.9)
        way = (word + shift - present) % 360
        if min(way, 360 - way, abs(way - 180)) < 1e-3:
            return None
        if kind == "ACN" or (kind == "DC" and way > 180):
            way -= 360
        return (f" {letter}={kind}({word})", present + way) if low <= present + way <= high else None

    def move(self, leads):
        incremental = self.chance(0.25)
        text = ("G91 " if incremental else "G90 ") + self.rng.choice(["G0", "G1 F500"])
        only_turns = self.chance(0.3)
        frameless = only_turns and self.chance(0.3)
        if frameless:
            text += self.rng.choice([" SUPA", " G53", " G153"])
        p, angles, old = self.point, dict(self.angles), self.angles
        for a in range(3):
            if only_turns or self.chance(0.4):
                continue
            by_mode = self.chance(0.2)
            if by_mode != incremental:
                d = self.number(-20, 20)
                p[a] += d
                text += f" {'XYZ'[a]}=IC({d})" if by_mode else f" {'XYZ'[a]}{d:.3f}"
            else:
                p[a] = self.number(-60, 60)
                text += f" {'XYZ'[a]}=AC({p[a]})" if by_mode else f" {'XYZ'[a]}{p[a]:.3f}"
        if leads or only_turns:
            for a in self.letters:
                if self.chance(0.5) and (word := self.turn_word(a, incremental, frameless)):
                    text += word[0]
                    angles[a] = word[1]
        if leads or not only_turns:
            self.tip_to(p, angles)
        else:
            self.angles = angles
        turns = any(abs(angles[a] - old[a]) > 1e-3 for a in old)
        self.expect(self.write(text), led=leads if turns else None)

    def vector(self):
        def draw():
            d = [round(self.rng.gauss(0, 1), 6) for _ in range(3)]
            t = unit(d)
            for frame in reversed(self.frames):
                t = along(frame, t)
            found = inside(self.machine, t, self.angles, self.travel)
            return d, least(found, lambda pair: sum(abs(pair[a] - self.angles[a]) for a in pair))
        d, angles = self.drawn(draw)
        p = self.some_point()
        line = self.write(f"G90 G1 {self.words(p)} A3={d[0]:.6f} B3={d[1]:.6f} C3={d[2]:.6f} F900")
        if angles is None:
            self.fail(line, "ISO-0443", "ISO-0444")
        self.tip_to(p, angles)
        self.expect(line)

    def whole_move(self):
        p = [round(c, 4) for c in self.some_point()]
        self.tip_to(p)
        self.expect(self.write("G90 G1 F800 " + self.words(p)))

    def frame(self):
        """TRANS, ROT, ATRANS, AROT: the last frame of the program."""
        own = self.frames[-1]
        x, y, z = AXES
        kind = self.rng.choice(["TRANS", "ATRANS", "ROT", "AROT"])
        if "TRANS" in kind:
            v = [self.number(-30, 30) for _ in range(3)]
            text, new = self.words(v), (v, *AXES)
        else:
            a, b, c = (self.number(-40, 40) for _ in range(3))
            # About Z, then the new Y, then the new X; a missing axis does not turn.
            text, new = f"X{a:.3f} Y{b:.3f} Z{c:.3f}", ([0.0] * 3, *turned_axes([(x, a), (y, b), (z, c)]))
        self.write(f"{kind} {text}")
        if kind[0] == "A":
            new = (out_of(own, new[0]), *(along(own, v) for v in new[1:]))
        self.frames[-1] = new

    def other_offset(self):
        """G55, and G54 back again."""
        if self.shift is self.first[1]:
            self.write("G55")
            self.work, self.shift = self.other
        else:
            self.write("G54")
            self.work, self.shift = self.first

    def under_traori(self):
        self.write("TRAORI")
        self.whole_move()
        for _ in range(self.rng.randint(3, 9)):
            self.rng.choice([lambda: self.move(True), lambda: self.move(True), self.vector])()
            if self.chance(0.15):
                self.frame()
                self.whole_move()
            if self.chance(0.1):
                self.other_offset()
                self.whole_move()
        if self.shift is not self.first[1]:
            self.other_offset()
        self.write("TRAFOOF")

    def tip_control(self):
        self.frames = [LEVEL, LEVEL]
        self.under_traori()
        self.write("TRANS")
        self.frames = [LEVEL]
        self.level()

    def level(self):
        p = self.some_point()
        self.plain_to(p)
        self.expect(self.write("G90 G0 " + self.words(p)), False)

    def some_swivel(self):
        """Mode, three turns, and the directions: each turn about the axis as turned so far."""
        a, b, c = self.some_plane_axes()
        if self.chance(0.2):
            return 64, (a, b, 0.0), turned_axes([(AXES[1], b), (AXES[2], a)])
        order = self.rng.choice([(1, 2, 3), (1, 3, 2), (2, 1, 3), (2, 3, 1), (3, 1, 2), (3, 2, 1)])
        turns = [(AXES[n - 1], v) for n, v in zip(order, (a, b, c))]
        return order[0] + 4 * order[1] + 16 * order[2], (a, b, c), turned_axes(turns[::-1])

    def choose(self, normal, sign):
        first = self.letters[0]
        found = inside(self.machine, normal, self.angles, self.travel, sign, first)
        if len(found) > 1:  # the manual does not say which of two that have the sign
            raise Unclear
        if found:
            return found[0]
        # The alternative: the smallest way of the first axis, of a table before that of a head.
        places = [axis[1] for axis in self.machine.axes]
        leading = self.letters[1 if places == ["head", "table"] else 0]
        found = inside(self.machine, normal, self.angles, self.travel)
        return least(found, lambda pair: abs(pair[leading] - self.angles[leading]))

    def planes(self):
        if self.chance(0.15):  # _DIR 0: no axis moves
            mode, values, _ = self.some_swivel()
            numbers = ",".join(f"{v:g}" for v in [mode, *self.some_point(), *values, 0, 0, 0, 0])
            line = self.write(f'CYCLE800(0,"",0,{numbers})')
            self.expect(line, False)
            self.write("CYCLE800()")
            self.level()
        present = LEVEL
        for count in range(self.rng.randint(1, 3)):
            is_added = count > 0 and self.chance(0.4)

            def draw():
                mode, values, axes = self.some_swivel()
                origin, behind = self.some_point(), [self.number(-20, 20) for _ in range(3)]
                plane = (plus(origin, along((None, *axes), behind)), *axes)
                if is_added:
                    plane = (out_of(present, plane[0]), *(along(present, v) for v in plane[1:]))
                sign = self.rng.choice([1, -1])
                return mode, values, origin, behind, plane, sign, self.choose(plane[3], sign)
            mode, values, origin, behind, plane, sign, upright = self.drawn(draw)
            numbers = ",".join(f"{v:g}" for v in [mode, *origin, *values, *behind, sign])
            line = self.write(f'CYCLE800(0,"",{int(is_added)},{numbers})')
            if upright is None:
                self.fail(line, "ISO-0443", "ISO-0444")
            self.frames = [plane, self.frames[-1] if is_added else LEVEL]
            present = plane
            self.angles = upright
            self.expect(line)
            self.whole_move()
            for _ in range(self.rng.randint(1, 4)):
                self.move(False)
                if self.chance(0.2):
                    self.frame()
                    self.whole_move()
            if self.chance(0.3):
                self.under_traori()
                self.whole_move()
        self.write("CYCLE800()")
        self.frames = [LEVEL]
        self.level()


class Fanuc(Program):
    dialect, extension = "fanuc", "nc"

    def tables(self):
        values = " ".join(f'{a}="{c!r}"' for a, c in [*zip("XYZ", self.work), *self.shift.items()])
        return (f'<ToolOffsetTable><Tool id="1" H="{self.own_length!r}"/></ToolOffsetTable>'
                f'<IsoCoordinateTable><Offset id="G54" {values}/></IsoCoordinateTable>')

    def words(self, p):
        return " ".join(f"{a}{c:.4f}" for a, c in zip("XYZ", p))

    def make(self):
        self.write("G21 G90 G94 G17 G54")
        self.write("G43 H1")
        self.length = self.own_length
        self.plain_to(p := self.some_point())
        self.angles = {a: self.some_angle(a) for a in self.letters}
        self.expect(self.write("G00 " + self.words(p) + "".join(
            f" {a}{self.angles[a] - self.shift[a]:.4f}" for a in self.letters)), False)
        for _ in range(self.rng.randint(2, 4)):
            self.rng.choice([self.vectors, self.planes])()

    def whole_move(self):
        p = [round(c, 4) for c in self.some_point()]
        self.tip_to(p)
        self.expect(self.write("G90 G01 F800. " + self.words(p)))

    def first(self, angles):
        places = [axis[1] for axis in self.machine.axes]
        leading = self.letters[1 if places == ["head", "table"] else 0]
        return abs(angles[leading] - self.angles[leading])

    def vectors(self):
        self.write("G43.5 H1")
        for _ in range(self.rng.randint(2, 6)):
            def draw():
                d = [round(self.rng.gauss(0, 1), 6) for _ in range(3)]
                return d, least(inside(self.machine, unit(d), self.angles, self.travel), self.first)
            d, angles = self.drawn(draw)
            p = self.some_point()
            line = self.write(f"G90 G01 {self.words(p)} I{d[0]:.6f} J{d[1]:.6f} K{d[2]:.6f} F900.")
            if angles is None:
                self.fail(line, "ISO-0443", "ISO-0444")
            self.tip_to(p, angles)
            self.expect(line)
        self.write("G43 H1")
        self.level()

    def level(self):
        p = self.some_point()
        self.plain_to(p)
        self.expect(self.write("G90 G00 " + self.words(p)), False)

    def planes(self):
        def draw():
            a, b, c = self.some_plane_axes()
            axes = turned_axes(list(zip(AXES, (a, b, c))))
            p = self.rng.choice([0, 0, 1, 2])
            sign = {0: 0, 1: 1, 2: -1}[p]
            found = inside(self.machine, axes[2], self.angles, self.travel, sign, self.letters[0])
            if p and len(found) > 1:  # the manual does not say which of two that have the sign
                raise Unclear
            return (a, b, c), axes, p, least(found, self.first)
        (a, b, c), axes, p, upright = self.drawn(draw)
        origin = self.some_point()
        self.write(f"G68.2 P1 Q123 {self.words(origin)} I{a} J{b} K{c}")
        lever = self.rng.choice([None, None, 0.0, self.number(-100, 100)])
        line = self.write(("G53.1" if lever is None else f"G53.6 R{lever}") + (f" P{p}" if p else ""))
        if upright is None:
            self.fail(line, "ISO-0443", "ISO-0444")
        rests = self.machine.in_workpiece(self.machine.tip(self.xyz, self.angles, self.length), self.angles)
        rests = minus(rests, times(lever or 0.0, self.machine.direction(self.angles)))
        self.angles = upright
        if lever is not None:
            tip = plus(rests, times(lever, self.machine.direction(upright)))
            self.xyz = minus(self.machine.part(tip, upright),
                             self.machine.hanging([0.0, 0.0, -self.length], upright))
        self.frames = [(origin, *axes)]
        self.expect(line)
        self.whole_move()
        for letter in self.letters:
            if self.chance(0.3):
                to = round(self.some_angle(letter), 4)
                self.angles = {**self.angles, letter: to}
                self.expect(self.write(f"G00 {letter}{to - self.shift[letter]:.4f}"))
        self.whole_move()
        self.write("G69")
        self.frames = [LEVEL]
        self.level()


KINDS = [Klartext, Sinumerik, Fanuc]


def run(isogloss, folder, program):
    rows = "".join(f'<Axis name="{a}"' + ('' if t == INFINITE else f' Minimum="{t[0]!r}" Maximum="{t[1]!r}"') +
                   f' Rollover="{int(t == INFINITE)}"/>' for a, t in program.travel.items())
    linear = "".join(f'<Axis name="{a}"/>' for a in "XYZ")
    (folder / "random.xml").write_text(f"""<?xml version="1.0" encoding="UTF-8"?>
<Dialect xmlns="urn:isogloss:dialect:1" name="random" title="random programs" extends="{program.dialect}">
  <Plugins><Plugin name="kinematics"/></Plugins>
  <Dependencies>{"<Remove dependency='FanucParameterTable'/>" if program.dialect == "fanuc" else ""}
    {program.tables()}<MachineAxes>{linear}{rows}</MachineAxes>{program.machine.xml()}</Dependencies>
</Dialect>
""")
    name = f"random.{program.extension}"
    (folder / name).write_text("\n".join(program.lines) + "\n")
    done = subprocess.run([isogloss, "run", name, "-d", "random.xml", "--emit", "motions", "--exact"], cwd=folder,
                          capture_output=True, text=True, check=False)
    if done.returncode > 1:
        raise RuntimeError(done.stderr)
    return [json.loads(line) for line in done.stdout.splitlines()], done.stderr


def fault(program, events, said):
    """What is wrong first, or None."""
    letters = program.letters
    last = {e["Line"]: e for e in events if e.get("Event") in ("rapid", "feed", "arc")}
    here = None
    for line in sorted({*program.goals, *program.fails}):
        block = f"line {line}: {program.lines[line - 1]}\n  "
        event = last.get(line)
        if line in program.fails:
            stays = here and event and all(here["MachineCoordinate"][a] == event["MachineCoordinate"][a] for a in letters)
            if (event and not stays) or not any(code in said for code in program.fails[line]):
                return f"{block}no angles give this direction inside the travel, and the axes turn: {event}"
            continue
        before, here = here, event or here
        if here is None:
            return f"{block}no move"
        xyz, angles, point = program.goals[line]
        if event is None:  # a move to where the tool stands already is no event, and the last one shows another frame
            event, point = here, None
        at = event["MachineCoordinate"]
        for a in letters:
            way = at.get(a, 0.0) - angles[a]
            if abs(way if program.counts_on or program.travel[a] != INFINITE else math.remainder(way, 360)) > 1e-6:
                return f"{block}{a} at {at.get(a)}, not at {angles}: {event}"
        for a, way in program.ways.get(line, {}).items():
            if before and abs(at.get(a, 0.0) - before["MachineCoordinate"].get(a, 0.0) - way) > 1e-6:
                return f"{block}{a} goes another way than {way}: {before} {event}"
        if event["Line"] == line and program.led.get(line, "Form" in event) != ("Form" in event):
            return f"{block}is the tip led? {event}"
        off = math.dist(xyz, [at[a] for a in "XYZ"])
        astray = math.dist(point, [event["ProgramXyz"][a] for a in "XYZ"]) if point else 0.0
        if off > 1e-6 or astray > 1e-6:
            return f"{block}the machine is off by {off:.3g} mm, the program point by {astray:.3g}: {event}\n  {xyz} {point}"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--programs", type=int, default=budgeted(90))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path, help="write the last program and its machine there")
    options = parser.parse_args()
    failures, checked, stops = [], 0, 0
    with tempfile.TemporaryDirectory(prefix="isogloss-dialects-") as name:
        folder = options.keep or pathlib.Path(name)
        folder.mkdir(exist_ok=True)
        for n in range(options.programs):
            rng = random.Random(f"{options.seed}/{n}")
            try:
                program = KINDS[n % len(KINDS)](rng, SHAPES[n // len(KINDS) % len(SHAPES)])
            except Unclear:
                continue
            events, said = run(options.isogloss.resolve(), folder, program)
            wrong = fault(program, events, said)
            checked += len(program.goals)
            stops += len(program.fails)
            if wrong:
                failures.append(f"program {n}, {program.dialect} {program.machine.axes} {program.machine.signs} "
                                f"{program.machine.zeros} {program.travel}: {wrong}\n{said}")
    for failure in failures[:40]:
        print(failure)
    print(f"{options.programs} programs, {checked} blocks, {stops} stops; {len(failures)} programs fail")
    return 1 if failures or checked < 5 * options.programs else 0


if __name__ == "__main__":
    sys.exit(main())
