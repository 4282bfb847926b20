#!/usr/bin/env python3
"""The speeds of the axes that a feed of the tip needs: the time of moves under tool centre point control.

  feed_test.py --isogloss PATH [--programs N] [--seed S]

A program of one move: the tip goes along a line, or rests, while the rotary axes turn. The machine is walked here in
many small steps; each takes as long as the feed demands, or as the slowest axis needs at its rapid rate. `isogloss run
--summary` must give the same feed time, and report whether an axis limited the feed.
"""
import argparse
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import budgeted  # noqa: E402: it lies in another folder

from tip_test import MACHINES, Machine, minus, plus, times

STEPS = 4000
TOLERANCE = 2e-3


def slides(machine, tip, angles, length):
    """Where X Y Z of the machine stand for the tip at a point of the workpiece."""
    return minus(machine.part(tip, angles), machine.hanging([0.0, 0.0, -length], angles))


def expected(machine, rates, move):
    """Seconds, and whether the rates limited the feed."""
    start, end, turned, length, feed = move
    way = math.dist(start, end)
    if way == 0:
        way = math.sqrt(sum(a * a for a in turned.values()))  # the feed of a tip that rests is in degrees
    by_feed = way / (feed / 60) / STEPS
    seconds, held, before = 0.0, False, None
    for i in range(STEPS + 1):
        u = i / STEPS
        angles = {a: u * turned[a] for a in machine.letters}
        here = slides(machine, plus(start, times(u, minus(end, start))), angles, length)
        if before is not None:
            least = max([abs(b - a) / (rates[n] / 60) for n, a, b in zip("XYZ", before, here)] +
                        [abs(turned[a]) / STEPS / (rates[a] / 60) for a in machine.letters])
            held = held or least > by_feed * 1.001
            seconds += max(least, by_feed)
        before = here
    return seconds, held


def run(isogloss, folder, machine, rates, move):
    start, end, turned, length, feed = move
    axes = "".join(f'<Axis name="{n}" RapidRate="{rates[n]}" Rollover="0"/>' if n in "ABC" else
                   f'<Axis name="{n}" RapidRate="{rates[n]}"/>' for n in rates)
    axes = f"<MachineAxes>{axes}</MachineAxes>"
    (folder / "machine.xml").write_text(f"<Dependencies>{axes}{machine.xml()}</Dependencies>")
    (folder / "tools.xml").write_text(f'<ToolOffsetTable><Tool id="1" H="{length}"/></ToolOffsetTable>')
    words = [" ".join(f"{n}{c:.4f}" for n, c in zip("XYZ", p)) for p in (start, end)]
    rest = " ".join(f"{a}0" for a in machine.letters)
    to = " ".join(f"{a}{turned[a]:.4f}" for a in machine.letters)
    (folder / "part.nc").write_text("\n".join(["G21 G90 G94 G54", f"G00 {rest}", f"G43.4 H1 {words[0]}",
                                               f"G01 {words[1]} {to} F{feed}", "M30", ""]))
    done = subprocess.run([isogloss, "run", "part.nc", "-d", "iso", "--machine", "machine.xml", "--tools", "tools.xml",
                           "--summary"], cwd=folder, capture_output=True, text=True, timeout=60, check=False)
    if done.returncode != 0:
        raise RuntimeError(done.stderr + done.stdout)
    return float(re.search(r"feed time: +([0-9.]+) s", done.stdout)[1]), "slowed feeds" in done.stdout


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--programs", type=int, default=budgeted(40))
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    rng = random.Random(options.seed)
    failures, slowed = 0, 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for i in range(options.programs):
            machine = Machine(rng, MACHINES[i % len(MACHINES)])
            machine.zeros = dict.fromkeys(machine.letters, 0.0)
            rates = {n: rng.choice([1000, 3000, 30000]) for n in "XYZ"}
            rates |= {a: rng.choice([1200, 36000]) for a in machine.letters}
            start = [round(rng.uniform(-60, 60), 4) for _ in range(3)]
            end = start if i % 4 == 3 else [round(rng.uniform(-60, 60), 4) for _ in range(3)]
            turned = {a: round(rng.uniform(-170, 170), 4) for a in machine.letters}
            move = (start, end, turned, round(rng.uniform(30, 200), 3), rng.choice([60, 600, 6000]))
            wanted, held = expected(machine, rates, move)
            seconds, said = run(options.isogloss.resolve(), folder, machine, rates, move)
            slowed += held
            if abs(seconds - wanted) > TOLERANCE * wanted + 0.001 or said != held:
                failures += 1
                print(f"program {i}: {seconds} s, expected {wanted:.4f} s; held back: {said}, expected {held}; {move}")
    print(f"{options.programs} moves, {slowed} held back, {failures} wrong")
    return 1 if failures or not 0 < slowed < options.programs else 0


if __name__ == "__main__":
    sys.exit(main())
