"""Which angles of two rotary axes give the tool a direction, from the description of the machine alone.

The tool's axis begins along Z; the heads turn it, the one nearer the tool first, then the tables turn the workpiece away
under it, which is a turn the other way round. So direction = Rot(outer) Rot(inner) Z, and a turn about the outer axis
does not change the share of the direction along it: an equation for the inner angle, c0 + c1 cos + c2 sin = share.
"""
import math

from tip_test import inner, minus, times, turned

INFINITE = (-math.inf, math.inf)
SAME = 1e-6


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def angle_about(n, u, v):
    """Degrees of the turn about n that takes u to v, or None where one of them lies along n."""
    flat_u, flat_v = minus(u, times(inner(u, n), n)), minus(v, times(inner(v, n), n))
    if min(inner(flat_u, flat_u), inner(flat_v, flat_v)) < 1e-12:
        return None
    return math.degrees(math.atan2(inner(n, cross(flat_u, flat_v)), inner(flat_u, flat_v)))


class Unclear(Exception):
    """The direction leaves an axis free, or is hardly reached: no case for a test."""


def pairs(machine, direction):
    """Up to two: {letter: angle}, as the machine shows them, whole turns aside."""
    turns = [a for a in reversed(machine.axes) if a[1] == "head"] + [a for a in machine.axes if a[1] == "table"]
    if len(turns) == 1:
        (letter, _, n, _), = turns
        turn = angle_about(n, [0.0, 0.0, 1.0], direction)
        if turn is None or abs(inner(n, direction) - n[2]) > 1e-9:
            if turn is None or abs(inner(n, direction) - n[2]) < 1e-4:
                raise Unclear
            return []
        return [{letter: machine.zeros.get(letter, 0.0) + machine.signs.get(letter, 1) * turn}]
    (b, _, nb, _), (a, _, na, _) = turns
    start = [0.0, 0.0, 1.0]
    along = inner(start, nb)
    flat = minus(start, times(along, nb))
    side = cross(nb, start)
    # na . Rot(nb, q) start
    c0, c1, c2 = along * inner(na, nb), inner(na, flat), inner(na, side)
    size, share = math.hypot(c1, c2), inner(na, direction) - c0
    if size < 1e-6 or abs(abs(share) - size) < 1e-5:
        raise Unclear
    if abs(share) > size:
        return []
    middle, half = math.atan2(c2, c1), math.acos(share / size)
    found = []
    for q in (middle + half, middle - half):
        inner_deg = math.degrees(q)
        outer_deg = angle_about(na, turned(start, nb, inner_deg), direction)
        if outer_deg is None:
            raise Unclear
        shown = {}
        for letter, geometric in ((a, outer_deg), (b, inner_deg)):
            shown[letter] = machine.zeros.get(letter, 0.0) + machine.signs.get(letter, 1) * geometric
        if math.dist(machine.direction(shown), direction) > 1e-8:
            raise AssertionError("the solver and the machine disagree")
        found.append(shown)
    return found


def turn_inside(angle, present, travel, wanted=lambda angle: True):
    """The turn of the angle nearest to the present one inside the wanted travel, or None."""
    low, high = travel
    nearest = angle + 360 * round((present - angle) / 360)
    fits = [a for a in (nearest + 360 * k for k in range(-3, 4)) if low - SAME <= a <= high + SAME and wanted(a)]
    if any(min(abs(a - low), abs(a - high)) < 1e-5 for a in fits):
        raise Unclear
    ways = sorted(fits, key=lambda a: abs(a - present))
    if len(ways) > 1 and abs(abs(ways[0] - present) - abs(ways[1] - present)) < 1e-3:
        raise Unclear
    return ways[0] if ways else None


def has_sign(sign, travel):
    """For an axis without limits the angle from -180 to 180 is used, for others the angle itself."""
    def test(angle):
        named = math.remainder(angle, 360) if travel == INFINITE else angle
        if abs(named) < 1e-4 or abs(abs(named) - 180) < 1e-4:
            raise Unclear
        return named * sign > 0
    return test if sign else lambda angle: True


def inside(machine, direction, present, travels, sign=0, master=None):
    """The pairs inside the travel, each in its nearest turn; the master axis in a turn with the sign."""
    out = []
    for pair in pairs(machine, direction):
        turns = {letter: turn_inside(angle, present[letter], travels[letter],
                                     has_sign(sign if letter == master else 0, travels[letter]))
                 for letter, angle in pair.items()}
        if None not in turns.values():
            out.append(turns)
    return out


def least(candidates, key):
    """The one with the smallest key; Unclear where two are close."""
    if not candidates:
        return None
    order = sorted(candidates, key=key)
    if len(order) > 1 and abs(key(order[0]) - key(order[1])) < 1e-3:
        raise Unclear
    return order[0]
