#!/usr/bin/env python3
"""Cycles with words that nobody would write: zero, tiny, huge, negative, too many. Whatever is reported, a run ends
soon, with status 0 or 1, no number is infinite or NaN, and no block becomes longer than the engine's budget."""
import argparse
import collections
import pathlib
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import budgeted  # noqa: E402: it lies in another folder

from cycles_test import CYCLES

VALUES = ["0", "0.", "-0.", "1", "-1", "1.", "5.", "-5.", "-20.", "0.001", "-0.001", "0.0001", "99999999.",
          "-99999999.", "1" + 300 * "0" + ".", "-1" + 300 * "0" + ".", "0." + 300 * "0" + "1", ".5", "2.", "7.3",
          "1000000"]
MODAL = ["G17", "G18", "G19", "G94", "G95", "G93", "G20", "G21", "G98", "G99", "G90", "G91", "M03", "M05"]
BETWEEN = ["G80", "G00 X1.", "G01 Z2. F100.", "G28 Z0.", "G04 X1.", "G53 Z0.", "G54", "G55", "G43 H1", "G92 X0.", "M19"]
SECONDS = 20
ITEMS = 100_000  # the engine's budget of a block


def program(rng, cycles):
    def words(low, high):
        return [a + rng.choice(VALUES) for a in rng.sample("XYZRQPIJKLF", rng.randrange(low, high))]

    lines = ["G21 G17 G90 G94", "G00 X0. Y0. Z50.", "M03 S500 F100."]
    for _ in range(25):
        kind = rng.random()
        if kind < 0.5:
            lines.append(" ".join([rng.choice(("G98", "G99", "G90", "G91")), rng.choice(cycles), *words(2, 9)]))
        elif kind < 0.75:
            lines.append(" ".join(words(1, 4)))
        elif kind < 0.8:
            lines.append(rng.choice(("M29 S", "S", "F")) + rng.choice(VALUES))
        else:
            lines.append(rng.choice(MODAL + BETWEEN))
    return "\n".join([*lines, "M30"]) + "\n"


def check(isogloss, path, dialect):
    """What is wrong, or None."""
    try:
        run = subprocess.run([isogloss, "run", path, "-d", dialect, "--zero-moves", "--emit", "motions", "--format",
                              "csv"], capture_output=True, text=True, timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return f"takes more than {SECONDS} s"
    if run.returncode not in (0, 1):
        return f"ends with {run.returncode}: {run.stderr[:500]}"
    rows = [row.split(",") for row in run.stdout.splitlines()[1:]]
    if any("nan" in cell or "inf" in cell for row in rows for cell in row[3:]):
        return "a number is infinite or none"
    line, most = max(collections.Counter(row[1] for row in rows).items(), key=lambda pair: pair[1])
    return f"line {line} has {most} events" if most > ITEMS else None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--cycles", default=CYCLES)
    parser.add_argument("--programs", type=int, default=budgeted(15))
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    failed = 0
    with tempfile.TemporaryDirectory(prefix="isogloss-extremes-") as name:
        path = pathlib.Path(name) / "p.nc"
        for seed in range(options.seed, options.seed + options.programs):
            path.write_text(program(random.Random(seed), options.cycles.split(",")))
            for dialect in ("fanuc", "iso"):
                what = check(options.isogloss.resolve(), path, dialect)
                if what:
                    failed += 1
                    print(f"seed {seed}, {dialect}: {what}\n{path.read_text()[:2000]}")
    print(f"{options.programs} programs in two dialects, {failed} runs fail")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
