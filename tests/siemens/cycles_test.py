#!/usr/bin/env python3
"""CYCLE81, CYCLE82, CYCLE83, CYCLE85 and CYCLE89 with random parameters, against an independent computation in exact
fractions.

  cycles_test.py --isogloss PATH [--cases 400] [--seed S]

The model follows the steps of the manual Cycles and knows nothing of the plugin. Calls stand alone or under MCALL, in
all three planes (in force, or of the call), downwards and upwards, with depths absolute and relative. Moves of no
length are left out on both sides.
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

SIGNATURES = {
    81: "RTP RFP SDIS DP DPR DTB GMODE DMODE AMODE",
    82: "RTP RFP SDIS DP DPR DTB GMODE DMODE AMODE",
    83: "RTP RFP SDIS DP DPR FDEP FDPR DAM DTB DTS FRF VARI AXN MDEP VRT DTD DIS1 GMODE DMODE AMODE",
    85: "RTP RFP SDIS DP DPR DTB FFR RFF GMODE DMODE AMODE",
    89: "RTP RFP SDIS DP DPR DTB GMODE DMODE AMODE",
}
PLANES = {"G17": "XYZ", "G18": "ZXY", "G19": "YZX"}  # the last one is the drilling axis
FEED, SPEED = F(200), F(600)
CLEAR = F(200)  # the tool comes from there, above or below


def digit(p, place):
    return int(p.get("AMODE", 0)) // 10 ** place % 10


def seconds(value, unit):
    """A time, or turns of the spindle: by the unit of AMODE, else by the sign."""
    in_turns = unit == 2 or (unit == 0 and value < 0)
    return abs(value) * 60 / SPEED if in_turns else abs(value)


def strokes(p, total):
    """The depths of CYCLE83 below the reference plane."""
    if digit(p, 4) == 2:
        first = abs(p["RFP"] - p["FDEP"])
    else:
        first = p["FDPR"] if p.get("FDPR") else abs(p["RFP"] - p["FDEP"])
    less, least = p.get("DAM", F(0)), p.get("MDEP", F(0))
    depths, stroke = [first], first
    factor = less / 100 if digit(p, 5) == 2 else -less if less < 0 else None
    while depths[-1] < total:
        left = total - depths[-1]
        if factor:
            stroke = max(stroke * factor, least)
        elif less > 0:
            if stroke - less >= less:
                stroke -= less
            elif left > 2 * less:
                stroke = less
            else:
                depths += [depths[-1] + left / 2, total]
                return depths
        depths.append(min(depths[-1] + stroke, total))
    return depths


def model(kind, p):
    """(event, level or seconds, feed) of one call."""
    out = 1 if p["UP"] > 0 else -1
    reference = p["RFP"]
    depth = reference - out * p["DPR"] if p.get("DPR") and digit(p, 0) != 2 else p["DP"]
    start = reference + out * p["SDIS"]
    wait = seconds(p.get("DTB", F(0)), digit(p, 1))
    yield "rapid", start, None
    if kind in (81, 82):
        yield "feed", depth, FEED
        yield "dwell", wait, None
    elif kind in (85, 89):
        inwards = p.get("FFR") or FEED if kind == 85 else FEED
        yield "feed", depth, inwards
        yield "dwell", wait, None
        yield "feed", start, (p.get("RFF") or inwards) if kind == 85 else FEED
    else:
        total = abs(reference - depth)
        factor = p.get("FRF") or F(1)
        if digit(p, 7) == 1 and p.get("FRF"):
            factor /= 100
        ahead = p.get("DIS1") or (F("0.6") if total <= 30 else min(total / 50, F(7)))
        if digit(p, 6) == 1:
            ahead = F("0.6") if total <= 30 else min(total / 50, F(7))
        depths = strokes(p, total)
        for k, below in enumerate(depths):
            if k and p.get("VARI"):
                yield "rapid", start, None
                yield "dwell", seconds(p.get("DTS", F(0)), digit(p, 2)), None
                yield "rapid", reference - out * (depths[k - 1] - ahead), None
            elif k:
                yield "feed", reference - out * (depths[k - 1] - (p.get("VRT") or 1)), FEED
            yield "feed", reference - out * below, FEED * factor if k == 0 else FEED
            last = k == len(depths) - 1
            yield "dwell", seconds(p["DTD"], digit(p, 3)) if last and p.get("DTD") else wait, None
    yield "rapid", p["RTP"], None


def draw(rnd):
    kind = rnd.choice(list(SIGNATURES))
    number = lambda low, high: F(rnd.randint(low * 100, high * 100), 100)
    some = lambda low, high: rnd.choice((F(0), number(low, high)))
    out = rnd.choice((1, 1, 1, -1))
    reference = number(-30, 30)
    total = number(5, 90)
    p = {"UP": F(out), "RFP": reference, "RTP": reference + out * number(6, 50), "SDIS": number(0, 5)}
    mode = [0] * 8
    if rnd.random() < 0.5:
        p["DP"], mode[0] = reference - out * total, rnd.choice((0, 2))
        if rnd.random() < 0.2:
            p["DPR"] = F(0)
    else:
        p["DPR"], mode[0] = total, rnd.choice((0, 1))
    if kind != 81 and rnd.random() < 0.7:
        p["DTB"], mode[1] = some(-9, 3), rnd.choice((0, 1, 2))
    if kind == 85:
        p["FFR"], p["RFF"] = some(50, 500), some(50, 500)
    if kind == 83:
        first = min(number(2, 40), total)
        if rnd.random() < 0.5:
            p["FDEP"], mode[4] = reference - out * first, rnd.choice((0, 2))
        else:
            p["FDPR"], mode[4] = first, rnd.choice((0, 1))
        way = rnd.choice(("none", "amount", "factor", "percent"))
        if way == "amount":
            p["DAM"], mode[5] = number(1, 20), rnd.choice((0, 1))
        elif way == "factor":
            p["DAM"], p["MDEP"] = -F(rnd.randint(50, 99), 100), number(1, 6)
        elif way == "percent":
            p["DAM"], p["MDEP"], mode[5] = F(rnd.randint(50, 100)), number(1, 6), 2
        p.update(DTS=some(-5, 2), DTD=some(-5, 2), VARI=F(rnd.randint(0, 1)), VRT=some(0, 3), DIS1=some(0, 3))
        mode[2], mode[3] = rnd.choice((0, 1, 2)), rnd.choice((0, 1, 2))
        mode[6] = rnd.choice((0, 1, 2))
        mode[7] = rnd.choice((0, 1))
        if rnd.random() < 0.5:
            p["FRF"] = F(rnd.randint(1, 100), 1 if mode[7] else 100)
    if rnd.random() < 0.6 or any(mode[5:]):
        p["AMODE"] = F(sum(d * 10 ** k for k, d in enumerate(mode)))
    if rnd.random() < 0.4:
        p["DMODE"] = F(rnd.randint(0, 3))
    return kind, p


def call(kind, p):
    words = ["" if n not in p else f"{float(p[n]):.2f}".rstrip("0").rstrip(".") or "0" for n in SIGNATURES[kind].split()]
    while words[-1] == "":
        words.pop()
    return f"CYCLE{kind}({','.join(words)})"


def program(cases, rnd):
    lines, starts = ["G90 G0 X0 Y0 Z0 F200 S600 M3"], []
    for i, (kind, p) in enumerate(cases):
        plane = rnd.choice(list(PLANES))
        of_call = int(p.get("DMODE", 0))
        first, _, tool = PLANES[list(PLANES)[of_call - 1] if of_call else plane]
        clear = float(CLEAR * p["UP"])
        if rnd.random() < 0.5:
            lines.append(f"{plane} G0 {first}={i + 1} {tool}={clear}")
            lines.append(call(kind, p))
            p["MOVE"] = False
        else:
            lines += [f"{plane} MCALL {call(kind, p)}", f"G0 {first}={i + 1} {tool}={clear}", "MCALL"]
            p["MOVE"] = True
        starts.append(len(lines) - p["MOVE"])
        p["AXIS"] = "xyz"["XYZ".index(tool)]
    return "\n".join(lines + ["M30"]) + "\n", starts


def events(isogloss, path):
    run = subprocess.run([isogloss, "run", path, "-d", "siemens", "--emit", "motions", "--format", "csv", "--exact"],
                         capture_output=True, text=True, check=False)
    if run.returncode != 0 or "warning" in run.stderr:
        sys.exit(f"exit status {run.returncode}\n{run.stderr}")
    out = {}
    for row in csv.DictReader(run.stdout.splitlines()):
        if row["event"] in ("dwell", "rapid", "feed"):
            out.setdefault(int(row["line"]), []).append(row)
    return out


def found(rows, axis):
    for row in rows:
        if row["event"] == "dwell":
            yield "dwell", float(row["value"]), None
        else:
            yield row["event"], float(row["p" + axis]), float(row["feed_mm_s"]) * 60 if row["feed_mm_s"] else None


def expected(kind, p):
    level = CLEAR * p["UP"]
    positioning = [("rapid", float(level), None)] if p["MOVE"] else []
    return [*positioning, *hole_events.expected(model(kind, p), level)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--cases", type=int, default=budgeted(400))
    parser.add_argument("--seed", default="1")
    options = parser.parse_args()
    rnd = random.Random(options.seed)
    cases = [draw(rnd) for _ in range(options.cases)]
    text, starts = program(cases, rnd)
    with tempfile.TemporaryDirectory(prefix="isogloss-siemens-") as folder:
        path = pathlib.Path(folder) / "cases.mpf"
        path.write_text(text)
        rows = events(options.isogloss.resolve(), path)
    failures = 0
    for (kind, p), line in zip(cases, starts):
        want, got = expected(kind, p), list(found(rows.get(line, []), p["AXIS"]))
        if hole_events.same(want, got):
            continue
        failures += 1
        if failures <= 3:
            print(f"line {line}: {call(kind, p)}\n  expected {want}\n  found    {got}")
    print(f"{len(cases)} cases, {failures} differ")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
