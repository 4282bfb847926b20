"""Whole runs: motions as arrays, diagnostics, a summary."""

from __future__ import annotations

import os
from typing import NamedTuple

import numpy as np

from . import _isogloss, _request
from ._errors import Error, diagnostics_of, raise_unless

#: The records of the binary stream, `isogloss run --format binary`: numpy.memmap(file, MOTION, "r", MOTION_OFFSET).
MOTION = np.dtype([
    ("line", "<u4"), ("file", "<u4"), ("event", "u1"), ("flags", "u1"), ("known", "<u2"), ("text", "<u4"),
    ("program", "<f8", 3), ("machine", "<f8", 6), ("feed", "<f8"), ("value", "<f8"), ("count", "<i8"),
    ("seconds", "<f8")])
#: Where the records of a stream begin.
MOTION_OFFSET = len(_isogloss.stream_header())
#: Where an arc lies whose centre is known; `motion` is its place among the motions.
CIRCLE = np.dtype([
    ("motion", "<i8"), ("center", "<f8", 3), ("machine_center", "<f8", 3), ("normal", "<f8", 3), ("sweep", "<f8")])
#: The names of events by their number in MOTION.
EVENTS = ("rapid", "feed", "arc", "dwell", "spindle", "orient", "tool", "coolant", "stop", "end")

_has_value = 8


class Motion(NamedTuple):
    """One event. Coordinates that are not known are nan, texts that an event lacks are empty."""

    file: str
    line: int
    event: str
    program: tuple[float, float, float]
    machine: tuple[float, float, float, float, float, float]
    feed: float
    seconds: float
    value: float
    count: int
    text: str


class Motions:
    """Events of a machine in the order in which it performs them: one row of `motions` each (dtype MOTION)."""

    def __init__(self, motions: np.ndarray, circles: np.ndarray, texts: list[str]):
        self.motions = motions.view(MOTION)
        self.circles = circles.view(CIRCLE)
        #: File names and terms by the numbers in the columns `file` and `text`.
        self.texts = texts

    def __len__(self) -> int:
        return len(self.motions)

    def __iter__(self):
        """Each event as a Motion: for scripts that go through them one by one. Arrays are a hundred times faster."""
        for begin in range(0, len(self.motions), 4096):
            for r in self.motions[begin:begin + 4096].tolist():
                line, file, event, _, _, text, program, machine, feed, value, count, seconds = r
                yield Motion(self.texts[file], line, EVENTS[event], tuple(program), tuple(machine), feed, seconds, value,
                             count, self.texts[text] if text < len(self.texts) else "")

    # Columns: views, without a copy.
    @property
    def positions(self) -> np.ndarray:
        """The ends in machine coordinates, X Y Z A B C: mm and degrees."""
        return self.motions["machine"]

    @property
    def program_positions(self) -> np.ndarray:
        """The ends in program coordinates, X Y Z in mm."""
        return self.motions["program"]

    @property
    def feeds(self) -> np.ndarray:
        """mm/s; deg/s of a move that only turns rotary axes."""
        return self.motions["feed"]

    @property
    def seconds(self) -> np.ndarray:
        """How long each event takes: moves without acceleration, dwells; nan where a rapid rate or a feed is not known."""
        return self.motions["seconds"]

    @property
    def times(self) -> np.ndarray:
        """When each event ends, from the start of the program; what is not known counts as no time."""
        return np.cumsum(np.nan_to_num(self.seconds))

    @property
    def lines(self) -> np.ndarray:
        return self.motions["line"]

    @property
    def events(self) -> np.ndarray:
        """Numbers into EVENTS."""
        return self.motions["event"]

    def is_move(self) -> np.ndarray:
        """A mask: rapid, feed and arc."""
        return self.motions["event"] <= 2

    def tools(self) -> np.ndarray:
        """The tool that is in the spindle at each event; -1 before the first one."""
        changes = np.flatnonzero(self.motions["event"] == EVENTS.index("tool"))
        numbers = np.concatenate(([-1], self.motions["count"][changes]))
        return numbers[np.searchsorted(changes, np.arange(len(self.motions)), side="right")]


class Result(Motions):
    """A run that is over."""

    def __init__(self, request, given, dialect, motions, circles, texts, diagnostics, summary):
        super().__init__(motions, circles, texts)
        self._given = given
        self.program: str = request.path
        self.dialect: str = dialect
        self.diagnostics = diagnostics
        #: Counts, lengths, times and extents, as `isogloss run --summary` adds them up; None with summary=False.
        self.summary: dict | None = summary

    def __repr__(self) -> str:
        return f"<isogloss.Result {self.program}, {self.dialect}: {len(self)} events, {len(self.diagnostics)} diagnostics>"

    @property
    def errors(self):
        return [d for d in self.diagnostics if d.severity == "error"]

    def check(self) -> "Result":
        """Raises Error when the program has errors; returns the result itself."""
        if self.errors:
            raise Error(self.diagnostics)
        return self

    def blocks(self):
        """Runs the program once more and gives each block's document; see isogloss.blocks()."""
        from ._blocks import blocks
        return blocks(**self._given)


def run(program=None, **given) -> Result:
    """Runs a program to its end.

    program: its path; or text="…", the program itself. dialect: a name or a file; without one it is guessed from text and
    extension, and a diagnostic says which (IG-0514). machine, offsets, tools, variables: as of the command. set: a dict such
    as {"IsoCoordinateTable.G54.Z": -120}. syntaxes: functions made by @isogloss.syntax. Further: block_skip,
    optional_stop, start_program, subprograms, main_passes, on_error, max_blocks, max_motions, max_diagnostics,
    zero_moves, summary, plugins, dialects, machines (folders), any_plugins: load plugins that others can write, too, which
    are refused otherwise (IG-0311).

    Raises Error when the run cannot start, Fault when a plugin fails. Errors of the program are in `diagnostics`.
    """
    request = _request.make(program, **given)
    started, said, dialect, motions, circles, texts, summary = _isogloss.run(request)
    diagnostics = diagnostics_of(said)
    raise_unless(started, diagnostics)
    return Result(request, {"program": program, **given}, dialect, motions, circles, texts, diagnostics, summary)


def read_motions(file) -> Motions:
    """Reads a binary stream that `isogloss run --emit motions --format binary` wrote. A damaged one raises Error."""
    said, motions, circles, texts = _isogloss.read_stream(os.fspath(file))
    if said:
        raise Error(diagnostics_of(said))
    return Motions(motions, circles, texts)
