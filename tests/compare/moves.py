"""Moves in machine coordinates: both sides are converted to them before they are compared."""
import csv
import dataclasses
import math

AXES = "XYZ"
# Plane -> indices of its first and second axis (the rotation from first to second is counter-clockwise) and its third.
PLANES = {"XY": (0, 1, 2), "ZX": (2, 0, 1), "YZ": (1, 2, 0)}


@dataclasses.dataclass
class Move:
    kind: str  # rapid, feed, arc, dwell, tool
    line: int
    slack: float  # how far off the printed numbers may be, mm
    end: tuple = ()  # mm
    angles: tuple = (0.0, 0.0, 0.0)  # of A, B and C, degrees
    feed: float | None = None  # mm/s
    plane: str = ""
    centre: tuple = ()  # in the plane: first, second axis
    ccw: bool = False
    sweep: float = 0.0  # degrees, always positive
    value: float = 0.0  # seconds, tool

    def __str__(self):
        text = f"line {self.line}: {self.kind}"
        if self.end:
            text += " " + " ".join(f"{a}{v:.6f}" for a, v in zip(AXES + "ABC", self.end + self.angles))
        if self.kind == "arc":
            text += (f" {self.plane} {'ccw' if self.ccw else 'cw'} centre {self.centre[0]:.6f} {self.centre[1]:.6f}"
                     f" sweep {self.sweep:.4f}")
        if self.feed is not None:
            text += f" feed {self.feed:.6f} mm/s"
        if self.kind in ("dwell", "tool"):
            text += f" {self.value:g}"
        return text


def sweep_of(start, end, centre, ccw):
    """Degrees from start to end about centre, each given as (first, second); a full circle where they coincide."""
    if math.dist(start, end) < 1e-6:
        return 360.0
    angle = (math.atan2(end[1] - centre[1], end[0] - centre[0])
             - math.atan2(start[1] - centre[1], start[0] - centre[0]))
    return math.degrees(angle if ccw else -angle) % 360.0


def without_zero_moves(moves):
    """Linear moves that go nowhere: one side prints them and the other does not."""
    position, angles = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
    for move in moves:
        if move.kind in ("rapid", "feed") and math.dist(position, move.end) <= max(5e-4, 2 * move.slack) and \
                math.dist(angles, move.angles) <= 5e-4:
            continue
        if move.end:
            position, angles = move.end, move.angles
        yield move


def difference(ours, theirs):
    """How two moves differ, or None."""
    if (ours.kind, ours.line) != (theirs.kind, theirs.line):
        return "another move" if ours.kind != theirs.kind else "another line"
    slack = max(ours.slack, theirs.slack)
    for axis, a, b in zip(AXES, ours.end, theirs.end):
        if abs(a - b) > slack:
            return f"{axis} of the end is {a - b:+.6f} mm off"
    for axis, a, b in zip("ABC", ours.angles, theirs.angles):
        if abs(a - b) > 1e-4:
            return f"{axis} is {a - b:+.6f} degrees off"
    if ours.kind == "arc":
        if (ours.plane, ours.ccw) != (theirs.plane, theirs.ccw):
            return "plane or sense"
        if math.dist(ours.centre, theirs.centre) > 2 * slack:
            return f"the centre is {math.dist(ours.centre, theirs.centre):.6f} mm off"
        first, second, _ = PLANES[ours.plane]
        radius = math.dist(ours.centre, (ours.end[first], ours.end[second]))
        if math.radians(abs(ours.sweep - theirs.sweep)) * radius > 6 * slack:
            return f"the sweep is {ours.sweep - theirs.sweep:+.4f} degrees off"
    if ours.kind in ("feed", "arc") and None not in (ours.feed, theirs.feed) and \
            abs(ours.feed - theirs.feed) > slack:
        return "feed"
    if abs(ours.value - theirs.value) > 1e-6:
        return "value"
    return None


def from_csv(text):
    """The motion stream of `isogloss run --emit motions --format csv`."""
    for row in csv.DictReader(text.splitlines()):
        kind, line = row["event"], int(row["line"])
        number = lambda key: float(row[key]) if row[key] else 0.0
        if kind in ("dwell", "tool"):
            yield Move(kind, line, 0.0, value=number("value"))
        if kind not in ("rapid", "feed", "arc"):
            continue
        move = Move(kind, line, 0.0, tuple(number(k) for k in ("mx", "my", "mz")),
                    tuple(number(k) for k in "abc"), float(row["feed_mm_s"]) if row["feed_mm_s"] else None)
        if kind == "arc":
            centre = [number(k) for k in ("mcx", "mcy", "mcz")]
            move.plane = row["plane"]
            first, second, _ = PLANES[move.plane]
            move.centre = (centre[first], centre[second])
            move.ccw = row["ccw"] in ("1", "true")
            move.sweep = abs(number("sweep"))
        yield move
