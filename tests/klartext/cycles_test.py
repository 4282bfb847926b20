#!/usr/bin/env python3
"""Cycles 200, 201, 203, 205 to 207, 209 and 240 with random parameters, against an independent computation in exact
fractions.

  cycles_test.py --isogloss PATH [--cases 400] [--seed S]

The model follows the manual's numbered steps and knows nothing of the plugin. Moves of no length are left out on both
sides.
"""
import argparse
import csv
import pathlib
import random
import subprocess
import sys
import tempfile
from fractions import Fraction as F

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

import hole_events  # noqa: E402: it lies in another folder
from budget import budgeted  # noqa: E402: it lies in another folder


def levels(q, kind):
    """Depths below the surface, positive, one for each infeed."""
    total, infeed = -q[201], q.get(202, F(0))
    if kind == 209:
        infeed = q[257]
    if kind in (201, 206, 207, 240) or infeed == 0 or infeed >= total:
        return [total]
    out, done = [], F(0)
    while done < total:
        done = min(done + infeed, total)
        out.append(done)
        if kind in (203, 205) and q[212] > 0:
            infeed = max(infeed - q[212], min(q[205], infeed))
    return out


def model(kind, q):
    """(event, Z or seconds, feed) of one call, the tool being anywhere above."""
    surface = q[203]
    safe = surface + q[200]
    end = surface + q[204] if q[204] > q[200] else safe
    retract = q.get(208) or q.get(206)
    depths = levels(q, kind)
    yield "rapid", safe, None
    if kind in (206, 207, 209):
        yield from tap(kind, q, depths)
        yield "rapid", end, None
        return
    if kind == 205:
        yield from peck(q, depths)
        yield "rapid", end, None
        return
    breaks = 0
    for k, depth in enumerate(depths):
        bottom = surface - depth
        yield "feed", bottom, q[206]
        if k == len(depths) - 1:
            break
        if kind == 200:
            yield "rapid", safe, None
            yield "dwell", q[210], None
            yield "rapid", min(bottom + q[200], safe), None
        elif breaks < q[213]:
            breaks += 1
            yield "rapid", min(bottom + q[256], safe), None
        else:
            yield "feed", safe, retract
            yield "dwell", q[210], None
            yield "rapid", min(bottom + (q[256] if q[213] else q[200]), safe), None
            breaks = 0
    yield "dwell", q[211], None
    if kind in (201, 203):
        yield "feed", safe, retract
    yield "rapid", end, None


def tap(kind, q, depths):
    """The program has S1000. A retract of 0 turns is one to the safe level."""
    surface, safe = q[203], q[203] + q[200]
    feed = q[206] if kind == 206 else 1000 * abs(q[239])
    for depth in depths:
        yield "feed", surface - depth, feed
        if kind == 206:
            yield "dwell", q[211], None
        back = abs(q[256] * q[239]) if kind == 209 and depth != depths[-1] else 0
        yield "feed", min(surface - depth + back, safe) if back else safe, feed


def peck(q, depths):
    surface, safe = q[203], q[203] + q[200]
    reached = F(0)
    for k, depth in enumerate(depths):
        while q[257] > 0 and depth - reached > q[257]:
            reached += q[257]
            yield "feed", surface - reached, q[206]
            yield "rapid", min(surface - reached + q[256], safe), None
        reached = depth
        yield "feed", surface - depth, q[206]
        if k == len(depths) - 1:
            break
        yield "rapid", safe, None
        share = F(k, len(depths) - 2) if len(depths) > 2 else F(0)
        yield "rapid", min(surface - depth + q[258] + share * (q[259] - q[258]), safe), None
    yield "dwell", q[211], None
    yield ("feed", safe, q[208] or q[206]) if 208 in q else ("rapid", safe, None)


def draw(rnd):
    kind = rnd.choice((200, 201, 203, 205, 206, 207, 209, 240))
    number = lambda low, high: F(rnd.randint(low * 100, high * 100), 100)
    q = {200: number(0, 5), 201: -number(1, 60), 206: number(50, 900), 203: number(-20, 20),
         204: rnd.choice((F(0), number(0, 80))), 211: rnd.choice((F(0), number(0, 2)))}
    if kind in (207, 209):
        del q[206], q[211]
        q[239] = rnd.choice((-1, 1)) * number(0, 2) or F(1)
    if kind == 209:
        q.update({257: rnd.choice((F(0), number(1, 30))), 256: rnd.choice((F(0), number(0, 3)))})
    if kind == 205:
        q.update({202: rnd.choice((F(0), number(3, 30))), 212: rnd.choice((F(0), number(0, 3))), 205: number(1, 4),
                  257: rnd.choice((F(0), number(1, 9))), 256: number(0, 1), 258: number(0, 2), 259: number(0, 2)})
        if rnd.random() < 0.5:
            q[208] = rnd.choice((F(0), number(50, 900)))
    if kind in (200, 203):
        q.update({202: rnd.choice((F(0), number(1, 30))), 210: rnd.choice((F(0), number(0, 1)))})
    if kind in (201, 203):
        q[208] = rnd.choice((F(0), number(50, 900)))
    if kind == 203:
        q.update({212: rnd.choice((F(0), number(0, 3))), 213: F(rnd.randint(0, 4)), 256: number(0, 1)})
        q[205] = number(1, 4)
    return kind, q


def program(cases):
    lines = ["0 BEGIN PGM CASES MM", "1 TOOL CALL 1 Z S1000", "2 L X+0 Y+0 Z+200 R0 FMAX"]
    starts = []
    for i, (kind, q) in enumerate(cases):
        lines.append(f"{len(lines)} CYCL DEF {kind} NAME ~")
        words = [f"    Q{n}={float(v):+.2f} ;TEXT" for n, v in q.items()]
        lines += [w + " ~" for w in words[:-1]] + [words[-1]]
        lines.append(f"{len(lines)} L X{i + 1:+d} Z+200 R0 FMAX M99")
        starts.append(len(lines))
    return "\n".join(lines + ["99 M30", "100 END PGM CASES MM"]) + "\n", starts


def events(isogloss, path):
    run = subprocess.run([isogloss, "run", path, "-d", "heidenhain", "--emit", "motions", "--format", "csv", "--exact"],
                         capture_output=True, text=True, check=False)
    if run.returncode != 0:
        sys.exit(f"exit status {run.returncode}\n{run.stderr}")
    out = {}
    for row in csv.DictReader(run.stdout.splitlines()):
        if row["event"] == "dwell":
            event = ("dwell", float(row["value"]), None)
        elif row["event"] in ("rapid", "feed"):
            event = (row["event"], float(row["pz"]), float(row["feed_mm_s"]) * 60 if row["feed_mm_s"] else None)
        else:
            continue
        out.setdefault(int(row["line"]), []).append(event)
    return out


def expected(kind, q):
    positioning = ("rapid", 200.0, None)
    return [positioning, *hole_events.expected(model(kind, q), F(200))]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--cases", type=int, default=budgeted(400))
    parser.add_argument("--seed", default="1")
    options = parser.parse_args()
    rnd = random.Random(options.seed)
    cases = [draw(rnd) for _ in range(options.cases)]
    text, starts = program(cases)
    with tempfile.TemporaryDirectory(prefix="isogloss-klartext-") as folder:
        path = pathlib.Path(folder) / "cases.h"
        path.write_text(text)
        found = events(options.isogloss.resolve(), path)
    failures = 0
    for (kind, q), line in zip(cases, starts):
        want, got = expected(kind, q), found.get(line, [])
        if hole_events.same(want, got):
            continue
        failures += 1
        if failures <= 3:
            print(f"cycle {kind} {({n: float(v) for n, v in q.items()})}\n  expected {want}\n  found    {got}")
    print(f"{len(cases)} cases, {failures} differ")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
