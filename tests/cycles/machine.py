"""Canned cycles as a Fanuc 0i/30i executes them: an independent interpreter that knows nothing of Isogloss.

Numbers are exact (fractions), so that a depth of three times Q is three pecks. A program whose motion is not certain
raises Uncertain. Where the manuals leave doubt, this module raises Uncertain too:

- Z or R missing in a cycle that has none stored; Q missing or zero in G73, G83, G76, G87; no F or F0
- R alone under G91 with a Z that was stored before (does Z go along?)
- a bottom that is not below R (except in G87)
- G80 or a motion code beside a cycle code; a change of the plane, of inches or of the frame within a cycle
- G87 under G99; G87 whose levels are not initial level > Z > R
- M29 that is not followed by G84 or G74 directly; a change between rigid tapping and another cycle without G80
- S, M03, M04 or M05 in rigid tapping

Spindle events of peck tapping between the first peck and the end are left to the machine (see worked_lists.txt).
"""
import dataclasses
import re
from fractions import Fraction

from events import Event

WORD = re.compile(r"([A-Z])\s*([-+]?(?:\d+\.?\d*|\.\d+))")
AXIS = {"X": 0, "Y": 1, "Z": 2}
PLANES = {17: "XYZ", 18: "ZXY", 19: "YZX"}  # first, second and third axis: the third is the drilling axis
MOTIONS = {0: "rapid", 1: "feed"}
REVERSE = {"CW": "CCW", "CCW": "CW"}
SHIFTS = {"+X": {17: "+X", 18: "+Z", 19: "+Y"}, "-X": {17: "-X", 18: "-Z", 19: "-Y"},
          "+Y": {17: "+Y", 18: "+X", 19: "+Z"}, "-Y": {17: "-Y", 18: "-X", 19: "-Z"}}


class Uncertain(Exception):
    """The manuals do not say what this program does, or this model does not."""


@dataclasses.dataclass
class Settings:
    peck: Fraction = Fraction(1)  # 5115: clearance of the re-approach in G83
    chip: Fraction = Fraction(1)  # 5114: return in G73
    tap: Fraction = Fraction(1)  # 5213: return, or cutting start distance, in peck tapping
    tap_to_r: bool = False  # 5200#5
    shift: str = "+X"  # 5101#4#5, by its name in G17


class Block:
    def __init__(self, text):
        text = re.sub(r"\([^)]*\)", " ", text)
        self.g, self.m, self.words = [], [], {}
        self.has_bare_feed = False  # F without a point
        for letter, number in WORD.findall(text):
            if letter == "G":
                self.g.append(Fraction(number))
            elif letter == "M":
                self.m.append(int(number))
            elif letter != "N":
                self.words[letter] = Fraction(number)
                self.has_bare_feed |= letter == "F" and "." not in number

    def last_of(self, codes):
        return next((int(g) for g in reversed(self.g) if g in codes), None)


class Machine:
    """The part that is the same for every cycle: modal codes, which blocks drill, levels and repeats."""

    BARE_FEED = {(False, 1): 1, (False, 20): 100, (True, 1): 100, (True, 20): 10000}  # F1 per minute, per turn; mm, inch
    MACHINE_LEVELS = True  # G87 cuts from R up to Z, P counts milliseconds, M29 is known
    CYCLES = (73, 74, 76, 81, 82, 83, 84, 85, 86, 87, 88, 89)

    def __init__(self, settings=None):
        self.settings = settings or Settings()
        self.events = []
        self.drilling_lines, self.loose_lines, self.unused_lines = set(), set(), set()
        self.line = 0
        self.at = [Fraction(0)] * 3
        self.plane, self.motion, self.incremental, self.return_to_r = 17, 0, False, False
        self.unit = Fraction(1)  # mm
        self.feed, self.per_revolution, self.speed = None, False, Fraction(0)
        self.spindle, self.coolant = "STOP", "OFF"
        self.ended = False
        self.forget()

    def forget(self):
        self.cycle = self.entry_level = self.level_r = self.level_z = None
        self.peck = self.pause = None
        self.rigid = False

    # -- what a step does

    def say(self, kind, value=None, by_hand=False):
        end = tuple(self.at) if kind in ("rapid", "feed") else ()
        self.events.append(Event(kind, self.line, end, value, by_hand))

    def to(self, kind, **axes):
        for name, value in axes.items():
            self.at[AXIS[name]] = value
        self.say(kind, self.feed_per_minute() if kind == "feed" else None)

    def feed_per_minute(self):
        if not self.feed:
            raise Uncertain("feed without F, or F0")
        if self.per_revolution and self.speed == 0:
            raise Uncertain("feed per revolution without S")
        return self.feed * self.speed if self.per_revolution else self.feed

    def turn(self, direction):
        self.spindle = direction
        self.say("spindle", direction)
        self.events[-1].speed = self.speed

    # -- a block

    def run(self, text):
        for row in text.splitlines():
            self.run_block(row)
        return self.events

    def run_block(self, row):
        self.line += 1
        if not self.ended and row.strip() not in ("", "%"):
            self.block(Block(row))

    def block(self, b):
        unknown = [g for g in b.g if g not in (0, 1, 4, 17, 18, 19, 20, 21, 40, 49, 54, 80, 90, 91, 94, 95, 98, 99)
                   and g not in self.CYCLES]
        if unknown:
            raise Uncertain(f"G{float(unknown[0]):g}")
        drill_code, motion, cancel = b.last_of(self.CYCLES), b.last_of(MOTIONS), 80 in b.g
        if drill_code and (motion is not None or cancel):
            raise Uncertain("a cycle and a motion code in one block")
        self.modal(b)
        if motion is not None or cancel:
            self.forget()
            self.motion = self.motion if motion is None else motion
        if drill_code:
            self.choose(drill_code)
        self.switch_on(b)
        if 4 in b.g:
            self.dwell_block(b)
        elif self.cycle:
            self.cycle_block(b)
        else:
            self.motion_block(b)
        self.switch_off(b)

    def modal(self, b):
        self.change_unit(b)
        plane = b.last_of(PLANES)
        if plane and plane != self.plane and self.cycle:
            raise Uncertain("another plane within a cycle")
        self.plane = plane or self.plane
        for code in b.g:
            if code in (90, 91):
                self.incremental = code == 91
            elif code in (98, 99):
                self.return_to_r = code == 99
            elif code in (94, 95):
                self.change_feed_mode(code == 95, "F" in b.words)
        self.feed = b.words.get("F", self.feed)
        if "S" in b.words:
            if self.rigid and 29 not in b.m:
                raise Uncertain("S in rigid tapping")
            self.speed = b.words["S"]
            if self.spindle in REVERSE and not any(m in b.m for m in (3, 4, 5, 29)):
                self.turn(self.spindle)

    def change_unit(self, b):
        """Lengths and feeds are mm from here on; the machine's settings and the F in force stay."""
        code = b.last_of((20, 21))
        if code:
            if self.cycle:
                raise Uncertain("another unit within a cycle")
            self.unit = Fraction("25.4") if code == 20 else Fraction(1)
        for letter in b.words:
            if letter in "YZRQIJF" or letter == "X" and 4 not in b.g:
                b.words[letter] *= self.unit
        if b.has_bare_feed:
            mode = b.last_of((94, 95))
            per_revolution = mode == 95 if mode else self.per_revolution
            b.words["F"] /= self.BARE_FEED[per_revolution, 1 if self.unit == 1 else 20]

    def change_feed_mode(self, per_revolution, has_feed):
        if per_revolution != self.per_revolution and not has_feed:
            self.feed = None
        self.per_revolution = per_revolution

    def switch_on(self, b):
        """Codes that act before the motion."""
        for code in b.m:
            if code in (3, 4):
                if self.rigid:
                    raise Uncertain("M03 in rigid tapping")
                self.turn("CW" if code == 3 else "CCW")
            elif code == 8 and self.coolant != "FLOOD":
                self.coolant = "FLOOD"
                self.say("coolant", "FLOOD")
            elif code == 29:
                self.tap_rigidly()
            elif code not in (0, 1, 5, 8, 9, 30):
                raise Uncertain(f"M{code}")

    def switch_off(self, b):
        for code in b.m:
            if code == 5:
                if self.rigid:
                    raise Uncertain("M05 in rigid tapping")
                self.turn("STOP")
            elif code == 9 and self.coolant != "OFF":
                self.coolant = "OFF"
                self.say("coolant", "OFF")
            elif code == 0:
                self.say("stop", "M00")
            elif code == 30:
                self.say("end", "M30")
                self.ended = True

    def seconds(self, p):
        return p / 1000

    def dwell_block(self, b):
        self.say("dwell", b.words["X"] if "X" in b.words else self.seconds(b.words["P"]))

    def motion_block(self, b):
        named = [a for a in "XYZ" if a in b.words]
        if named:
            base = self.at if self.incremental else [0] * 3
            self.to(MOTIONS[self.motion], **{a: base[AXIS[a]] + b.words[a] for a in named})

    # -- cycles

    def tap_rigidly(self):
        if self.cycle:
            raise Uncertain("M29 within a cycle")
        self.rigid = True
        self.turn("STOP")

    def choose(self, code):
        if self.rigid and code not in (74, 84):
            raise Uncertain("another cycle in rigid tapping")
        if self.cycle is None:
            self.entry_level = self.at[self.drilling_axis()]
        self.cycle = code

    def drilling_axis(self):
        return AXIS[PLANES[self.plane][2]]

    def initial_level(self):
        return self.entry_level  # fixed until the cycle mode ends

    def cycle_block(self, b):
        if not any(a in b.words for a in "XYZR"):
            if any(a in b.words for a in "QPIJKL"):
                self.unused_lines.add(self.line)  # nobody takes these words: a warning of the interpreter is right
            return
        self.drilling_lines.add(self.line)
        words = b.words
        first, second, third = PLANES[self.plane]
        self.peck = words.get("Q", self.peck)
        self.pause = words.get("P", self.pause)
        if self.incremental and "R" in words and third not in words and self.level_z is not None:
            raise Uncertain("R alone under G91")
        if "R" in words:
            self.level_r = words["R"] + (self.initial_level() if self.incremental else 0)
        if third in words:
            if self.incremental and self.level_r is None:
                raise Uncertain("no R")
            self.level_z = words[third] + (self.level_r if self.incremental else 0)
        repeats = words.get("K", words.get("L", 1))
        if repeats == 0:
            return
        if self.level_r is None or self.level_z is None:
            raise Uncertain("no R or no bottom")
        for _ in range(int(repeats)):
            hole = {a: words[a] + (self.at[AXIS[a]] if self.incremental else 0) for a in (first, second) if a in words}
            self.drill(hole)

    def drill(self, position):
        hole = Hole(self, position)
        if self.cycle != 87 and not hole.z < hole.r:
            raise Uncertain("a bottom above R")
        if self.cycle == 87 and (self.return_to_r or not hole.initial > hole.z > hole.r):
            raise Uncertain("G87 and its levels")
        CYCLES[self.cycle](hole)


class Hole:
    """One hole: the words of its cycle as levels, and the steps that a cycle is made of."""

    def __init__(self, machine, position):
        self.machine, self.position = machine, position
        self.axis = PLANES[machine.plane][2]
        self.initial, self.r, self.z = machine.initial_level(), machine.level_r, machine.level_z
        self.top = self.r if machine.return_to_r else self.initial
        self.settings = machine.settings
        self.rigid = machine.rigid

    def q(self):
        if not self.machine.peck:
            raise Uncertain("no Q")
        return abs(self.machine.peck)

    def rapid_to_hole(self):
        self.machine.to("rapid", **self.position)

    def rapid(self, level):
        self.machine.to("rapid", **{self.axis: level})

    def feed(self, level):
        self.machine.to("feed", **{self.axis: level})

    def by_hand(self, level):
        self.rapid(level)
        self.machine.events[-1].by_hand = True

    def dwell(self):
        if self.machine.pause:
            self.machine.say("dwell", self.machine.seconds(self.machine.pause))

    def turn(self, direction):
        self.machine.turn(direction)

    def orient(self):
        self.machine.spindle = "orient"
        self.machine.say("orient")

    def shift_vector(self):
        direction = SHIFTS[self.settings.shift][self.machine.plane]
        return direction[1], self.q() if direction[0] == "+" else -self.q()

    def shift(self, way):
        """Sideways by Q: +1 away from the tip of the tool, -1 back."""
        axis, amount = self.shift_vector()
        self.machine.to("rapid", **{axis: self.machine.at[AXIS[axis]] + way * amount})

    def approach(self):
        self.rapid_to_hole()
        self.rapid(self.r)

    def leave(self):
        """From R to the initial level under G98."""
        if not self.machine.return_to_r:
            self.rapid(self.initial)

    def depths(self):
        """The depth of each peck: R less k times Q, the last one the bottom."""
        k = 1
        while self.r - k * self.q() > self.z:
            yield self.r - k * self.q()
            k += 1
        yield self.z


def drilling(hole):
    hole.approach()
    hole.feed(hole.z)
    hole.rapid(hole.top)


def counterboring(hole):
    hole.approach()
    hole.feed(hole.z)
    hole.dwell()
    hole.rapid(hole.top)


def high_speed_peck(hole):
    hole.approach()
    for depth in hole.depths():
        hole.feed(depth)
        if depth != hole.z:
            hole.rapid(depth + hole.settings.chip)
    hole.rapid(hole.top)


def peck(hole):
    hole.approach()
    for depth in hole.depths():
        hole.feed(depth)
        if depth != hole.z:
            hole.rapid(hole.r)
            hole.rapid(depth + hole.settings.peck)
    hole.rapid(hole.top)


def floating_tapping(hole, forward):
    hole.approach()
    hole.feed(hole.z)
    hole.turn("STOP")
    hole.dwell()
    hole.turn(REVERSE[forward])
    hole.feed(hole.r)
    hole.turn("STOP")
    hole.dwell()
    hole.turn(forward)
    hole.leave()


def rigid_tapping(hole, forward):
    hole.approach()
    hole.turn(forward)
    if hole.machine.peck:
        hole.machine.loose_lines.add(hole.machine.line)
        tap_pecks(hole)
    hole.feed(hole.z)
    hole.turn("STOP")
    hole.dwell()
    hole.turn(REVERSE[forward])
    hole.feed(hole.r)
    hole.turn("STOP")
    hole.dwell()
    hole.leave()


def tap_pecks(hole):
    """All but the last one; every move at the feed, since the spindle turns with it."""
    for depth in hole.depths():
        if depth == hole.z:
            return
        hole.feed(depth)
        if hole.settings.tap_to_r:
            hole.feed(hole.r)
        hole.feed(depth + hole.settings.tap)


def tapping(forward):
    return lambda hole: (rigid_tapping if hole.rigid else floating_tapping)(hole, forward)


def reaming(hole):
    hole.approach()
    hole.feed(hole.z)
    hole.feed(hole.r)
    hole.leave()


def boring_with_stop(hole):
    hole.approach()
    hole.feed(hole.z)
    hole.turn("STOP")
    hole.rapid(hole.top)
    hole.turn("CW")


def boring_by_hand(hole):
    hole.approach()
    hole.feed(hole.z)
    hole.dwell()
    hole.turn("STOP")
    hole.by_hand(hole.r)
    hole.turn("CW")
    hole.leave()


def boring_with_dwell(hole):
    hole.approach()
    hole.feed(hole.z)
    hole.dwell()
    hole.feed(hole.r)
    hole.leave()


def fine_boring(hole):
    hole.approach()
    hole.feed(hole.z)
    hole.dwell()
    hole.orient()
    hole.shift(+1)
    hole.rapid(hole.top)
    hole.shift(-1)
    hole.turn("CW")


def back_boring(hole):
    hole.rapid_to_hole()
    hole.orient()
    hole.shift(+1)
    hole.rapid(hole.r)
    hole.shift(-1)
    hole.turn("CW")
    hole.feed(hole.z)
    hole.dwell()
    hole.orient()
    hole.shift(+1)
    hole.rapid(hole.initial)
    hole.shift(-1)
    hole.turn("CW")


CYCLES = {73: high_speed_peck, 74: tapping("CCW"), 76: fine_boring, 81: drilling, 82: counterboring, 83: peck,
          84: tapping("CW"), 85: reaming, 86: boring_with_stop, 87: back_boring, 88: boring_by_hand,
          89: boring_with_dwell}
