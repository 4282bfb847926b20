#!/usr/bin/env python3
"""Random programs of G16, G51, G51.1, G90 and G91 beside a model of a few lines: the end of every move must agree."""
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

AXES = "XYZ"


class Model:
    """How the control changes the words: polar, then scaling, then mirror image."""

    def __init__(self):
        self.at = [0.0, 0.0, 0.0]
        self.is_incremental = False
        self.center, self.factor = [0, 0, 0], [1, 1, 1]
        self.mirror = {}
        self.pole, self.radius, self.angle = None, 0, 0

    def forward(self, i, x):
        x = self.factor[i] * (x - self.center[i]) + self.center[i]
        return 2 * self.mirror[i] - x if i in self.mirror else x

    def backward(self, i, x):
        x = 2 * self.mirror[i] - x if i in self.mirror else x
        return (x - self.center[i]) / self.factor[i] + self.center[i]

    def begin_polar(self):
        tool = [self.backward(i, self.at[i]) for i in range(2)]
        self.pole = tool if self.is_incremental else [0, 0]
        u, v = tool[0] - self.pole[0], tool[1] - self.pole[1]
        self.radius, self.angle = math.hypot(u, v), math.degrees(math.atan2(v, u))

    def move(self, words):
        linear = dict(words)
        if self.pole is not None and (0 in words or 1 in words):
            self.radius = linear.pop(0, self.radius)
            self.angle = (self.angle if self.is_incremental or 1 not in words else 0) + linear.pop(1, 0)
            a = math.radians(self.angle)
            for i, way in ((0, math.cos(a)), (1, math.sin(a))):
                self.at[i] = self.forward(i, self.pole[i] + self.radius * way)
        for i, word in linear.items():
            sign = -1 if i in self.mirror else 1
            self.at[i] = self.at[i] + sign * self.factor[i] * word if self.is_incremental else self.forward(i, word)
        return list(self.at)


def program(rng, blocks):
    """Lines, and the expected end of each line that moves."""
    model, lines, ends = Model(), ["%", "O1", "G17 G90 G21 G54", "G00 X0 Y0 Z0"], {}
    for _ in range(blocks):
        choice = rng.random()
        if choice < 0.08:
            model.center = [round(rng.uniform(-50, 50), 2) for _ in AXES]
            counts = [rng.choice([-1, 1]) * rng.randint(100, 3000) for _ in AXES]
            if rng.random() < 0.5:
                counts = [abs(counts[0])] * 3
                factors = f"P{counts[0]}"
            else:
                factors = " ".join(f"{letter}{n}" for letter, n in zip("IJK", counts))
            model.factor = [n / 1000 for n in counts]
            lines.append("G51 " + " ".join(f"{a}{c:.2f}" for a, c in zip(AXES, model.center)) + " " + factors)
        elif choice < 0.12:
            model.center, model.factor = [0, 0, 0], [1, 1, 1]
            lines.append("G50")
        elif choice < 0.20:
            axis, at = rng.randrange(3), round(rng.uniform(-50, 50), 2)
            model.mirror[axis] = at
            lines.append(f"G51.1 {AXES[axis]}{at:.2f}")
        elif choice < 0.24:
            axis = rng.randrange(3)
            model.mirror.pop(axis, None)
            lines.append(f"G50.1 {AXES[axis]}0")
        elif choice < 0.30:
            model.is_incremental = not model.is_incremental
            lines.append("G91" if model.is_incremental else "G90")
        elif choice < 0.36 and model.pole is None:
            model.begin_polar()
            lines.append("G16")
        elif choice < 0.36:
            model.pole = None
            lines.append("G15")
        else:
            words = {i: round(rng.uniform(-90, 90), 3) for i in range(3) if rng.random() < 0.6}
            if words:
                lines.append(" ".join(f"{AXES[i]}{word:.3f}" for i, word in words.items()))
                ends[len(lines)] = model.move(words)
    return lines + ["M30", "%"], ends


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--isogloss", required=True)
    parser.add_argument("--programs", type=int, default=budgeted(60))
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    rng = random.Random(options.seed)
    moves = wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        for number in range(options.programs):
            lines, ends = program(rng, 60)
            path = pathlib.Path(folder) / f"{number}.nc"
            path.write_text("\n".join(lines) + "\n")
            run = subprocess.run([options.isogloss, "run", path, "-d", "fanuc", "--zero-moves"], capture_output=True,
                                 text=True, check=False)
            got = {}
            for line in run.stdout.splitlines():
                event = json.loads(line)
                if "ProgramXyz" in event:
                    got[event["Line"]] = [event["ProgramXyz"][axis] for axis in AXES]
            for line, end in ends.items():
                moves += 1
                tolerance = 1e-6 * max(1, *(abs(x) for x in end))
                if line in got and all(abs(a - b) <= tolerance for a, b in zip(got[line], end)):
                    continue
                wrong += 1
                if wrong <= 5:
                    print(f"program {number} line {line}: {lines[line - 1]}: {got.get(line)}, expected {end}")
    print(f"{options.programs} programs, {moves} moves, {wrong} differ (seed {options.seed})")
    return 1 if wrong or not moves else 0


if __name__ == "__main__":
    sys.exit(main())
