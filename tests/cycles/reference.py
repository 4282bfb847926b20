"""Canned cycles of the reference behaviour, step by step as its documents describe them, for the dialect `iso`.

The documents say little about modal codes, about which blocks drill and about repeats: these are those of machine.py,
and so is G88. Every step is an event, including steps that go nowhere. P has no effect where the sequence has no dwell.
"""
from fractions import Fraction

import machine
from machine import AXIS, REVERSE, Hole, Machine, Settings, Uncertain


class Reference(Machine):
    BARE_FEED = dict.fromkeys(Machine.BARE_FEED, 1)
    MACHINE_LEVELS = False

    def __init__(self, settings=None):
        super().__init__(settings or Settings(peck=Fraction(5), chip=Fraction(5)))

    def seconds(self, p):
        return p

    def change_feed_mode(self, per_revolution, has_feed):
        self.per_revolution = per_revolution  # the number stays

    def initial_level(self):
        return self.previous_level

    def cycle_block(self, b):
        self.previous_level = self.at[self.drilling_axis()]  # the level before the block
        super().cycle_block(b)

    def tap_rigidly(self):
        raise Uncertain("M29 in the reference behaviour")

    def drill(self, position):
        self.previous_level = self.at[self.drilling_axis()]  # "target XY, previous Z"
        steps = Steps(self, position)
        if not steps.z < steps.r:  # in G87 too
            raise Uncertain("a bottom that is not below R")
        STEPS[self.cycle](steps)


class Steps(Hole):
    """The steps by their names in the documents; `final` is the initial level under G98, R under G99."""

    def __init__(self, control, position):
        super().__init__(control, position)
        self.final = self.top
        self.d_g83, self.d_g73 = self.settings.peck, self.settings.chip

    def rapid_to_hole_shifted(self):
        axis, amount = self.shift_vector()
        position = self.position.get(axis, self.machine.at[AXIS[axis]])
        self.machine.to("rapid", **{**self.position, axis: position + amount})

    def strokes(self):
        """(depths of the whole strokes, is there a remainder)"""
        whole, rest = divmod(self.r - self.z, self.q())
        return [self.r - k * self.q() for k in range(1, int(whole) + 1)], rest != 0


def drilling(s):  # G81
    s.rapid_to_hole()
    s.rapid(s.r)
    s.feed(s.z)
    s.rapid(s.final)


def drilling_with_dwell(s):  # G82
    s.rapid_to_hole()
    s.rapid(s.r)
    s.feed(s.z)
    s.dwell()
    s.rapid(s.final)


def peck_drilling(s):  # G83
    s.rapid_to_hole()
    s.rapid(s.r)
    strokes, remainder = s.strokes()
    previous = None
    for depth in strokes + ([s.z] if remainder else []):
        if previous is not None:
            s.rapid(previous + s.d_g83)
        s.feed(depth)
        s.rapid(s.r)
        previous = depth
    s.rapid(s.final)


def high_speed_peck(s):  # G73
    s.rapid_to_hole()
    s.rapid(s.r)
    strokes, remainder = s.strokes()
    for depth in strokes:
        s.feed(depth)
        s.rapid(depth + s.d_g73)
    if remainder:
        s.feed(s.z)
        s.rapid(s.z + s.d_g73)
    s.rapid(s.final)


def tapping(forward):  # G84, G74
    def steps(s):
        s.rapid_to_hole()
        s.rapid(s.r)
        s.feed(s.z)
        s.turn(REVERSE[forward])
        s.feed(s.final)
        s.turn(forward)
    return steps


def boring(s):  # G85
    s.rapid_to_hole()
    s.rapid(s.r)
    s.feed(s.z)
    s.feed(s.final)


def boring_with_stop(s):  # G86
    s.rapid_to_hole()
    s.rapid(s.r)
    s.feed(s.z)
    s.turn("STOP")
    s.rapid(s.final)
    s.turn("CW")


def boring_with_dwell(s):  # G89
    s.rapid_to_hole()
    s.rapid(s.r)
    s.feed(s.z)
    s.dwell()
    s.feed(s.final)


def fine_boring(s):  # G76
    s.rapid_to_hole()
    s.rapid(s.r)
    s.feed(s.z)
    s.orient()
    s.shift(+1)
    s.rapid(s.final)
    s.shift(-1)
    s.turn("CW")


def back_boring(s):  # G87: from the bottom Z up to R
    s.orient()
    s.rapid_to_hole_shifted()
    s.rapid(s.z)
    s.shift(-1)
    s.turn("CW")
    s.feed(s.r)
    s.orient()
    s.shift(+1)
    s.rapid(s.final)
    s.shift(-1)
    s.turn("CW")

STEPS = {73: high_speed_peck, 74: tapping("CCW"), 76: fine_boring, 81: drilling, 82: drilling_with_dwell,
         83: peck_drilling, 84: tapping("CW"), 85: boring, 86: boring_with_stop, 87: back_boring,
         88: machine.boring_by_hand, 89: boring_with_dwell}
