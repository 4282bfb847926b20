"""Closed contours of lines and arcs, and distances from them: nothing here knows how a compensated path is made."""
import cmath
import math
import random

TURN = 2 * math.pi


class Line:
    def __init__(self, start, end):
        self.start, self.end = start, end

    def at(self, t):
        return self.start + t * (self.end - self.start)

    def direction(self, _t):
        way = self.end - self.start
        return way / abs(way)

    def distance(self, p):
        way = self.end - self.start
        length = abs(way)
        if length == 0:
            return abs(p - self.start)
        along = ((p - self.start) * way.conjugate()).real / length
        if along <= 0 or along >= length:
            return min(abs(p - self.start), abs(p - self.end))
        return abs(((p - self.start) * way.conjugate()).imag) / length


class Arc:
    def __init__(self, start, end, center, ccw, sweep=None):
        self.start, self.end, self.center, self.ccw = start, end, center, ccw
        if sweep is None:
            sweep = cmath.phase((end - center) / (start - center))
            if ccw and sweep <= 1e-12:
                sweep += TURN
            if not ccw and sweep >= -1e-12:
                sweep -= TURN
        self.sweep = sweep

    def at(self, t):
        return self.center + (self.start - self.center) * cmath.exp(1j * t * self.sweep)

    def direction(self, t):
        out = self.at(t) - self.center
        return out / abs(out) * (1j if self.ccw else -1j)

    def distance(self, p):
        out = p - self.center
        radius = abs(self.start - self.center)
        if abs(out) > 0:
            turned = cmath.phase(out / (self.start - self.center))
            turned = turned % TURN if self.ccw else -(-turned % TURN)
            if abs(turned) <= abs(self.sweep):
                return abs(abs(out) - radius)
        return min(abs(p - self.start), abs(p - self.end))


def distance(elements, p):
    return min(e.distance(p) for e in elements)


def bulged(start, end, sagitta):
    """The arc over a chord; a positive height bulges to the right of the way and turns counter-clockwise."""
    chord = end - start
    half = abs(chord) / 2
    radius = (half * half + sagitta * sagitta) / (2 * abs(sagitta))
    to_center = (radius - abs(sagitta)) * (1j if sagitta > 0 else -1j) * chord / abs(chord)
    return Arc(start, end, (start + end) / 2 + to_center, sagitta > 0)


def rounded_corner(before, after, radius):
    """Lines shortened by an arc that touches both, or None where there is no room."""
    u, v = before.direction(1), after.direction(0)
    bend = cmath.phase(v / u)
    cut = radius * math.tan(abs(bend) / 2)
    if abs(bend) < 0.1 or abs(bend) > 2.6 or cut > 0.4 * min(abs(before.end - before.start), abs(after.end - after.start)):
        return None
    first, second = before.end - cut * u, after.start + cut * v
    center = first + radius * (1j if bend > 0 else -1j) * u
    return Line(before.start, first), Arc(first, second, center, bend > 0), Line(second, after.end)


def random_contour(seed, tool):
    """Starts and ends in the middle of a straight side."""
    rng = random.Random(seed)
    n = rng.randint(3, 9)
    angles = [TURN / n * (i + rng.uniform(-0.35, 0.35)) for i in range(n)]
    corners = [cmath.rect(rng.uniform(25, 80), a) for a in angles]
    if rng.random() < 0.5:
        corners.reverse()
    corners = [complex(round(c.real, 3), round(c.imag, 3)) for c in corners]
    sides = []
    for i, corner in enumerate(corners):
        end = corners[(i + 1) % n]
        if i > 0 and rng.random() < 0.35:
            sides.append(bulged(corner, end, rng.choice([-1, 1]) * rng.uniform(0.02, 0.3) * abs(end - corner)))
        else:
            sides.append(Line(corner, end))
    middle = sides[0].at(0.5)
    elements = [Line(middle, sides[0].end), *sides[1:], Line(sides[0].start, middle)]
    i = 0
    while i + 1 < len(elements):
        if isinstance(elements[i], Line) and isinstance(elements[i + 1], Line) and rng.random() < 0.4:
            radius = rng.uniform(*rng.choice([(0.2, 0.9), (1.2, 3), (1.2, 3)])) * tool
            joined = rounded_corner(elements[i], elements[i + 1], radius)
            if joined:
                elements[i:i + 2] = joined
                i += 1
        i += 1
    bends = [abs(cmath.phase(b.direction(0) / a.direction(1))) for a, b in zip(elements, elements[1:] + elements[:1])]
    return elements if max(bends) < 2.8 and is_simple(elements) else None  # a cusp may cross itself unseen


def is_simple(elements):
    """Does the contour nowhere cross itself? By polygons of many sides."""
    points = [e.at(k / 24) for e in elements for k in range(24)]
    sides = list(zip(points, points[1:] + points[:1]))
    cross = lambda a, b: (a.conjugate() * b).imag
    for i, (a, b) in enumerate(sides):
        for c, d in sides[i + 2:len(sides) - (i == 0)]:
            if cross(b - a, c - a) * cross(b - a, d - a) < -1e-9 and cross(d - c, a - c) * cross(d - c, b - c) < -1e-9:
                return False
    return True


class Reach:
    """Where the tool, beside the contour, touches it without cutting into another part."""

    SAMPLES = 60

    def __init__(self, elements, offset):
        self.places = []  # for each element the centres of the tool that touches it
        self.is_narrow = False  # parts that are no neighbours are in each other's way
        self.is_swallowed = False  # an element that the tool cannot touch at all
        tool = abs(offset)
        for i, e in enumerate(elements):
            reached = []
            for k in range(self.SAMPLES + 1):
                t = k / self.SAMPLES
                center = e.at(t) + offset * 1j * e.direction(t)
                near = min(range(len(elements)), key=lambda j: elements[j].distance(center))
                if elements[near].distance(center) >= tool - 1e-9:
                    reached.append(center)
                elif min((near - i) % len(elements), (i - near) % len(elements)) > 2:
                    self.is_narrow = True
            self.places.append(reached)
            self.is_swallowed |= not reached
