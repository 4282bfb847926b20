"""The canonical calls that LinuxCNC's rs274 prints, turned into moves in machine coordinates.

Calls are in program coordinates and in the unit of the program, with four decimals; work offset, G52/G92, rotation and
tool length are announced: machine = R(rotation) (program + g92) + g5x + tool."""
import math
import re

from moves import PLANES, Move, sweep_of

CALL = re.compile(r"^\s*\d+\s+N(\d+|\.+)\s+([A-Z0-9_]+)\((.*)\)\s*$")
CANON_PLANES = {"CANON_PLANE_XY": "XY", "CANON_PLANE_XZ": "ZX", "CANON_PLANE_YZ": "YZ"}


class Canon:
    def __init__(self):
        self.unit = 1.0  # mm
        self.work = self.local = self.tool = (0.0, 0.0, 0.0)
        self.rotation = 0.0
        self.plane = "XY"
        self.feed = None
        self.inverse_time = False
        self.position = (0.0, 0.0, 0.0)  # machine
        self.angles = (0.0, 0.0, 0.0)
        self.ended = False

    def machine(self, point):
        x, y, z = (p * self.unit + l for p, l in zip(point, self.local))
        cos, sin = math.cos(self.rotation), math.sin(self.rotation)
        turned = (x * cos - y * sin, x * sin + y * cos, z)
        return tuple(p + w + t for p, w, t in zip(turned, self.work, self.tool))

    def slack(self):
        # Half of the fourth decimal, in inches more than the tenth of a micron that is asked for otherwise.
        return max(1e-4, 0.55e-4 * self.unit)

    def straight(self, kind, line, numbers):
        self.position = self.machine(numbers[:3])
        self.angles = tuple(numbers[3:6])
        return Move(kind, line, self.slack(), self.position, self.angles, self.feed_rate() if kind == "feed" else None)

    def feed_rate(self):
        return None if self.inverse_time or self.feed is None else self.feed * self.unit / 60

    def arc(self, line, numbers):
        end1, end2, centre1, centre2, turns, end3 = numbers[:6]
        first, second, third = PLANES[self.plane]
        start = self.position
        end, centre = [0.0] * 3, [0.0] * 3
        end[first], end[second], end[third] = end1, end2, end3
        centre[first], centre[second], centre[third] = centre1, centre2, end3
        end, centre = self.machine(end), self.machine(centre)
        flat = lambda p: (p[first], p[second])
        self.position = end
        move = Move("arc", line, self.slack(), end, self.angles, self.feed_rate(), self.plane, flat(centre), turns > 0)
        move.sweep = sweep_of(flat(start), flat(end), move.centre, move.ccw) + 360 * (abs(turns) - 1)
        return move

    def read(self, text):
        for row in text.splitlines():
            call = CALL.match(row)
            if not call:
                continue
            number, name, arguments = call.groups()
            line = int(number) if number.isdigit() else 0
            numbers = [float(n) for n in re.findall(r"-?\d+\.?\d*", arguments)]
            lengths = lambda at: tuple(n * self.unit for n in numbers[at:at + 3])
            if name == "STRAIGHT_TRAVERSE":
                yield self.straight("rapid", line, numbers)
            elif name == "STRAIGHT_FEED":
                yield self.straight("feed", line, numbers)
            elif name == "ARC_FEED":
                yield self.arc(line, numbers)
            elif name == "DWELL":
                yield Move("dwell", line, 0.0, value=numbers[0])
            elif name == "CHANGE_TOOL":
                yield Move("tool", line, 0.0, value=numbers[0])
            elif name == "USE_LENGTH_UNITS":
                self.unit = 25.4 if arguments == "CANON_UNITS_INCHES" else 1.0
            elif name == "SET_G5X_OFFSET":
                self.work = lengths(1)
            elif name == "SET_G92_OFFSET":
                self.local = lengths(0)
            elif name == "USE_TOOL_LENGTH_OFFSET":
                self.tool = lengths(0)
            elif name == "SET_XY_ROTATION":
                self.rotation = math.radians(numbers[0])
            elif name == "SELECT_PLANE":
                self.plane = CANON_PLANES[arguments]
            elif name == "SET_FEED_RATE":
                self.feed = numbers[0]
            elif name == "SET_FEED_MODE":
                self.inverse_time = bool(numbers[1])
            elif name == "PROGRAM_END":
                self.ended = True
