#!/usr/bin/env python3
"""Random swings: G53.6 with R or H, and PLANE ... MOVE DIST. Does the resting point lie still during the whole swing?

  swing_test.py --isogloss PATH [--programs N] [--seed S]

The tool swings about a point beside its tip. Between two events of `isogloss run` the angles change evenly and the tip
goes straight in the workpiece (Form ClLinear); walked forwards so (tip_test.Machine), the resting point may leave
its place by no more than the tolerance. Then a limit is set between the ends of the swing and its farthest place:
ISO-0403 must be reported.
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

from tip_test import REACHING, Machine, minus, plus, times  # noqa: E402

TOLERANCE_MM = 0.01
PARTS = 8  # looks at each event


def positions(events, machine, begin):
    """X Y Z and the angles after each move, from `begin`; then those of the line of the swing."""
    for event in events:
        if event.get("Event") not in ("rapid", "feed"):
            continue
        at = event["MachineCoordinate"]
        here = [at[a] for a in "XYZ"], {a: at.get(a, begin[1][a]) for a in machine.letters}
        yield event, begin, here
        begin = here


class Swing:
    def __init__(self, rng, shape, dialect):
        self.dialect = dialect
        self.machine = Machine(rng, shape)
        self.length = round(rng.uniform(40, 200), 3)
        self.lever = round(rng.choice([1, 1, -1]) * rng.uniform(20, 300), 3)
        self.other_length = round(self.length + rng.choice([-1, 1]) * rng.uniform(10, 60), 3)
        start = [round(rng.uniform(-80, 80), 3) for _ in range(3)]
        a, b, c = (round(rng.uniform(-70, 70), 3) for _ in range(3))
        if dialect == "heidenhain":
            self.lines = ["0 BEGIN PGM S MM", "1 TOOL CALL 1 Z S1000",
                          "2 L X{:+} Y{:+} Z{:+} R0 FMAX".format(*start),
                          f"3 PLANE SPATIAL SPA{a:+} SPB{b:+} SPC{c:+} MOVE DIST{self.lever:+} F2000", "4 END PGM S MM"]
            self.line = 4
        else:
            words = rng.choice([f"R{self.lever}", f"H2 R{self.lever}", "H2"])
            if "H2" in words:
                self.lever = (self.lever if "R" in words else 0) + self.other_length - self.length
            self.lines = ["G21 G90 G94 G17 G54", "G43 H1", "G00 X{} Y{} Z{}".format(*start),
                          f"G68.2 P1 Q123 X0 Y0 Z0 I{a} J{b} K{c}", f"G53.6 {words}", "M30"]
            self.line = 5

    def rests(self, at, lever=None):
        """The position in the workpiece of the point that must not move."""
        xyz, angles = at
        t = self.machine.direction(angles)
        tip = self.machine.in_workpiece(self.machine.tip(xyz, angles, self.length), angles)
        return minus(tip, times(self.lever if lever is None else lever, t))

    def between(self, begin, end, u):
        """The tip goes straight in the workpiece, the angles evenly."""
        m = self.machine
        angles = {a: begin[1][a] + u * (end[1][a] - begin[1][a]) for a in m.letters}
        first, last = (m.in_workpiece(m.tip(*at, self.length), at[1]) for at in (begin, end))
        tip = plus(first, times(u, minus(last, first)))
        return minus(m.part(tip, angles), m.hanging([0.0, 0.0, -self.length], angles)), angles

    def xml(self, limits=""):
        return f"""<?xml version="1.0" encoding="UTF-8"?>
<Dialect xmlns="urn:isogloss:dialect:1" name="swing" title="swings" extends="{self.dialect}">
  <Plugins><Plugin name="kinematics"/></Plugins>
  <Dependencies>
    <ToolOffsetTable><Tool id="1" H="{self.length!r}"/><Tool id="2" H="{self.other_length!r}"/></ToolOffsetTable>
    <MachineAxes>{"".join(f'<Axis name="{a}" Home="0" {limits if a == limits[:1] else ""}/>' for a in "XYZ")}
    {"".join(f'<Axis name="{a}"/>' for a in self.machine.letters)}</MachineAxes>
    {self.machine.xml()}
  </Dependencies>
</Dialect>
"""

    def run(self, isogloss, folder, dialect):
        (folder / "swing.xml").write_text(dialect)
        name = "swing.h" if self.dialect == "heidenhain" else "swing.nc"
        (folder / name).write_text("\n".join(self.lines) + "\n")
        done = subprocess.run([isogloss, "run", name, "-d", "swing.xml", "--emit", "motions", "--exact", "--zero-moves"],
                              cwd=folder, capture_output=True, text=True, check=False)
        if done.returncode > 1:
            raise RuntimeError(done.stderr)
        return [json.loads(line) for line in done.stdout.splitlines()], done.stderr


def limited(dialect, axis, minimum, maximum):
    return dialect.replace(f'<Axis name="{axis}" Home="0" ', f'<Axis name="{axis}" Home="0" Minimum="{minimum!r}" '
                                                            f'Maximum="{maximum!r}" ')


def fault(swing, isogloss, folder):
    """(what is wrong or None, whether a limit was tried)"""
    events, said = swing.run(isogloss, folder, swing.xml())
    origin = [0.0] * 3, {a: 0.0 for a in swing.machine.letters}
    moves = [m for m in positions(events, swing.machine, origin) if m[0]["Line"] == swing.line]
    if not moves:
        return f"no move: {said}", False
    begin, end = moves[0][1], moves[-1][2]
    still = swing.rests(begin)
    for event, before, after in moves:
        if event.get("Form") != "ClLinear":
            return f"not led: {event}", False
        for k in range(PARTS + 1):
            off = math.dist(still, swing.rests(swing.between(before, after, k / PARTS)))
            if off > TOLERANCE_MM + 1e-6 or (k in (0, PARTS) and off > 1e-6):
                return f"the point that rests is off by {off:.3g} mm in {event}\n{said}", False
    # What the machine really does: the angles go evenly from end to end.
    m, t = swing.machine, []
    for k in range(201):
        angles = {a: begin[1][a] + k / 200 * (end[1][a] - begin[1][a]) for a in m.letters}
        tip = plus(still, times(swing.lever, m.direction(angles)))
        t.append(minus(m.part(tip, angles), m.hanging([0.0, 0.0, -swing.length], angles)))
    for i, axis in enumerate("XYZ"):
        ends = [0.0] + [p[i] for p in (begin[0], end[0])]
        highest, lowest = max(p[i] for p in t), min(p[i] for p in t)
        if highest < max(ends) + 1 and lowest > min(ends) - 1:
            continue
        top = (max(ends) + highest) / 2 if highest >= max(ends) + 1 else highest + 1000
        low = (min(ends) + lowest) / 2 if lowest <= min(ends) - 1 else lowest - 1000
        _, said = swing.run(isogloss, folder, limited(swing.xml(), axis, low, top))
        if "ISO-0403" not in said:
            return f"{axis} leaves {low} to {top} ({lowest} to {highest}) and nothing says so: {said}", True
        return None, True
    return None, False


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--programs", type=int, default=budgeted(40))
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    failures, limits = [], 0
    with tempfile.TemporaryDirectory(prefix="isogloss-swing-") as name:
        for n in range(options.programs):
            rng = random.Random(f"{options.seed}/{n}")
            swing = Swing(rng, REACHING[n % len(REACHING)], ("iso", "fanuc", "heidenhain")[n % 3])
            wrong, tried = fault(swing, options.isogloss.resolve(), pathlib.Path(name))
            limits += tried
            if wrong:
                failures.append(f"program {n}, {swing.dialect} {swing.machine.axes} {swing.lines}:\n  {wrong}")
    for failure in failures[:5]:
        print(failure)
    print(f"{options.programs} swings, {limits} limits in the middle of one; {len(failures)} fail")
    return 1 if failures or limits * 4 < options.programs else 0


if __name__ == "__main__":
    sys.exit(main())
