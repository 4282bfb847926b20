#!/usr/bin/env python3
"""Random programs of G92, G28, G30 and moves on a machine whose reference return ends the shift of G92, beside a model
of a few lines: the place in the machine at the end of each block must agree."""
import json
import math
import pathlib
import random
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

import random_runs  # noqa: E402: it lies in another folder

AXES = "XYZABC"
ORIGIN = (10, -20, 30, 4, 0, -6)  # of G54
HOME = {"G28": (0, 1, 2, 3, 4, 5), "G30 P2": (-1, -2, -3, -4, -5, -6)}
SHIFT = (0.5, -0.25, 2, 0, 0, 0)  # at the start

DIALECT = """<Dialect xmlns="urn:isogloss:dialect:1" name="home-cancels" extends="iso">
  <Initial>
    <Field path="WorkCoordinateShift.Offset_X" value="0.5"/>
    <Field path="WorkCoordinateShift.Offset_Y" value="-0.25"/>
    <Field path="WorkCoordinateShift.Offset_Z" value="2"/>
  </Initial>
  <Chain> <Configure syntax="WorkCoordinateShiftSyntax" reference-return="cancel"/> </Chain>
</Dialect>
"""


def words(values):
    return " ".join(f"{AXES[axis]}{value}." for axis, value in values.items())


class Model:
    def __init__(self):
        self.shift, self.at = list(SHIFT), [o + s for o, s in zip(ORIGIN, SHIFT)]  # the first block goes to 0
        self.named = []

    def block(self, code, values):
        """The machine's axes at the end of the block. G28 and G30 end the shift when the next block begins."""
        for axis in self.named:
            self.shift[axis] = 0
        self.named = []
        for axis, value in values.items():
            if code == "G92":
                self.shift[axis] = self.at[axis] - ORIGIN[axis] - value
            else:
                self.at[axis] = HOME[code][axis] if code in HOME else ORIGIN[axis] + self.shift[axis] + value
        if code in HOME:
            self.named = list(values)
        return list(self.at)


class Program:
    def __init__(self, seed):
        rng, model = random.Random(seed), Model()
        self.lines, self.ends = ["O1", "G17 G90 G21 G54", "G00 X0. Y0. Z0. A0. B0. C0."], {}
        for _ in range(60):
            code = rng.choice(["G00", "G00", "G92", *HOME])
            values = {axis: rng.randint(-90, 90) for axis in sorted(rng.sample(range(6), rng.randint(1, 4)))}
            at = model.block(code, values)
            self.lines.append(f"{code} {words(values)}")
            if code != "G92":
                self.ends[len(self.lines)] = at
        self.lines.append("M30")


def arguments():
    """The tables of the machine: G54, and the two reference positions."""
    out = []
    for axis, name in enumerate(AXES):
        out += ["--set", f"IsoCoordinateTable.G54.{name}={ORIGIN[axis]}",
                "--set", f"MachineAxes.{name}.Reference1={HOME['G28'][axis]}",
                "--set", f"MachineAxes.{name}.Reference2={HOME['G30 P2'][axis]}"]
    return out


def agree(place, expected):
    """A rotary axis goes the short way, so that it may stand whole turns away."""
    ways = [a - b for a, b in zip(place, expected)]
    return all(abs(way if axis < 3 else math.remainder(way, 360)) < 1e-6 for axis, way in enumerate(ways))


def difference(isogloss, folder, program):
    (folder / "home-cancels.xml").write_text(DIALECT)
    path = folder / "shift.nc"
    path.write_text("\n".join(program.lines) + "\n")
    done = subprocess.run([isogloss, "run", path, "-d", folder / "home-cancels.xml", *arguments(), "--zero-moves"],
                          capture_output=True, text=True, check=False)
    got = {}
    for line in done.stdout.splitlines():
        event = json.loads(line)
        if "MachineCoordinate" in event:
            got[event["Line"]] = [event["MachineCoordinate"].get(axis, 0) for axis in AXES]
    for count, (line, end) in enumerate(program.ends.items()):
        if line not in got or not agree(got[line], end):
            return count, f"line {line}, {program.lines[line - 1]}: {got.get(line)}, expected {end}\n{done.stderr[:400]}"
    return len(program.ends), None


if __name__ == "__main__":
    sys.exit(random_runs.run(__doc__, Program, difference, ".nc"))
