#!/usr/bin/env python3
"""Canned cycles inside tilted planes: a program drills the same holes in a tilted plane as on the level, moved there.

  cycles_test.py --isogloss PATH [--programs N] [--seed S]

Random programs of cycles, of G17 to G19, in mm and inches, run twice: as they are, and in a random plane of G68.2. The
second must have the same events, each machine position that of the first, turned and shifted by the formula of
tilt_test.py, to 1e-6 mm. G76 and G87 are left out: their shift is in the machine's axes.
"""
import argparse
import csv
import math
import pathlib
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import budgeted  # noqa: E402: it lies in another folder

from tilt_test import by_euler

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "cycles"))
from random_programs import RandomProgram  # noqa: E402: it lies beside this folder

CYCLES = (73, 74, 81, 82, 83, 84, 85, 86, 88, 89)


def events(isogloss, folder, lines):
    (folder / "in.nc").write_text("\n".join(lines) + "\n")
    run = subprocess.run([isogloss, "run", "in.nc", "-d", "fanuc", "--emit", "motions", "--format", "csv", "--exact",
                          "--zero-moves"], cwd=folder, capture_output=True, text=True, timeout=60, check=False)
    return list(csv.DictReader(run.stdout.splitlines())), run.stderr


def difference(level, tilted, plane):
    if [e["event"] for e in level] != [e["event"] for e in tilted]:
        return "other events"
    for a, b in zip(level, tilted):
        if a["event"] not in ("rapid", "feed"):
            continue
        wanted = plane.out([float(a[c]) for c in ("px", "py", "pz")])
        got = [float(b[c]) for c in ("mx", "my", "mz")]
        if math.dist(wanted, got) > 1e-6 or a["feed_mm_s"] != b["feed_mm_s"]:
            return f"line {b['line']}: {got}, wanted {wanted}"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--programs", type=int, default=budgeted(25))
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    isogloss = options.isogloss.resolve()
    compared = differing = 0
    with tempfile.TemporaryDirectory(prefix="isogloss-tilt-") as name:
        folder = pathlib.Path(name)
        for seed in range(options.seed, options.seed + options.programs):
            rng = random.Random(seed)
            lines = RandomProgram(seed, cycles=CYCLES).lines
            origin = [round(rng.uniform(-50, 50), 3) for _ in range(3)]
            angles = [round(rng.uniform(-180, 180), 3) for _ in range(3)]
            words = " ".join(f"{a}{v:.3f}" for a, v in zip("XYZIJK", origin + angles))
            level, _ = events(isogloss, folder, lines)
            tilted, said = events(isogloss, folder, [f"{lines[0]} G68.2 {words}", *lines[1:]])
            compared += len(level)
            what = difference(level, tilted, by_euler(origin, *angles))
            if what:
                differing += 1
                print(f"seed {seed}, G68.2 {words}: {what}\n{said[:500]}")
    print(f"{options.programs} programs, {compared} events, {differing} programs differ")
    return 1 if differing or compared < 20 * options.programs else 0


if __name__ == "__main__":
    sys.exit(main())
