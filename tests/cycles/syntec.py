"""Canned cycles as a Syntec executes them: those of machine.py, with these differences.

- one distance (Pr4002) for the retract of G73, the clearance of G83 and the retract of peck tapping
- P waits after each peck of G73 and G83; without a decimal point it counts milliseconds, with one seconds
- tapping is rigid without M29
- F without a decimal point counts units
- G70 is G20, G71 is G21
"""
import re
from fractions import Fraction

import machine
from machine import Hole, Machine, Settings, Uncertain
from random_programs import RandomProgram


class Syntec(Machine):
    BARE_FEED = dict.fromkeys(Machine.BARE_FEED, 1)

    def __init__(self, settings=None):
        super().__init__(settings or Settings())

    def run_block(self, row):
        """P as seconds, and the codes that the machine knows."""
        code = re.sub(r"\([^)]*\)", " ", row)
        code = re.sub(r"P([-+]?\d+)(?![\d.])", lambda m: f"P{float(Fraction(m[1]) / 1000):.6f}", code)
        super().run_block(code.replace("G70", "G20").replace("G71", "G21"))

    def seconds(self, p):
        return p

    def tap_rigidly(self):
        raise Uncertain("M29 on a control that taps rigidly by itself")

    def drill(self, position):
        if self.cycle not in CYCLES:
            super().drill(position)
            return
        hole = Hole(self, position)
        if not hole.z < hole.r:
            raise Uncertain("a bottom above R")
        CYCLES[self.cycle](hole)


def high_speed_peck(hole):
    hole.approach()
    for depth in hole.depths():
        hole.feed(depth)
        hole.dwell()
        if depth != hole.z:
            hole.rapid(depth + hole.settings.peck)
    hole.rapid(hole.top)


def peck(hole):
    hole.approach()
    for depth in hole.depths():
        hole.feed(depth)
        hole.dwell()
        if depth != hole.z:
            hole.rapid(hole.r)
            hole.rapid(depth + hole.settings.peck)
    hole.rapid(hole.top)


def tapping(forward):
    return lambda hole: machine.rigid_tapping(hole, forward)


CYCLES = {73: high_speed_peck, 74: tapping("CCW"), 83: peck, 84: tapping("CW")}


class SyntecProgram(RandomProgram):
    def __init__(self, seed, settings, cycles=None):
        super().__init__(seed, model_of(settings), cycles)

    def unit(self):
        self.attempt(self.random.choice(("G70", "G71", "G20", "G21")))

    def dwell_word(self):
        p = self.random.randrange(0, 2000, 50)
        return f"P{p}" if self.chance(0.5) else f"P{p // 1000}.{p % 1000:03}"


def model_of(settings):
    """Syntec on this machine, as the class from which a random program makes its model."""
    return type("SyntecOf", (Syntec,), {"__init__": lambda self: Syntec.__init__(self, settings)})
