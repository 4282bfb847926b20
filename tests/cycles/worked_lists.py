"""Reads worked_lists.txt."""
import dataclasses
import pathlib
import re
from fractions import Fraction

from events import Event
from machine import Settings

START = "G21 G17 G90 G94\nG00 X0. Y0. Z50.\n"


@dataclasses.dataclass
class Example:
    title: str
    settings: Settings
    program: str  # with the start
    events: list  # of the program without its start; lines are not known


def read():
    text = (pathlib.Path(__file__).parent / "worked_lists.txt").read_text()
    for part in text.split("\n## ")[1:]:
        title, _, rest = part.partition("\n")
        program, _, steps = rest.partition("-> ")
        settings = Settings()
        for name, value in re.findall(r"^= (\w+) (\S+)$", program, re.MULTILINE):
            setattr(settings, name, value if name == "shift" else Fraction(value))
        program = re.sub(r"^=.*\n", "", program, flags=re.MULTILINE)
        yield Example(title, settings, START + program, [event(s) for s in steps.splitlines() if s.strip()])


def event(text):
    kind, *words = text.split()
    by_hand = words[-2:] == ["by", "hand"]
    if kind in ("rapid", "feed"):
        number = {w[0]: Fraction(w[1:]) for w in words if w[0] in "XYZF"}
        return Event(kind, 0, tuple(number[a] for a in "XYZ"), number.get("F"), by_hand)
    value = None if not words else Fraction(words[0]) if kind == "dwell" else words[0]
    return Event(kind, 0, value=value)
