#!/usr/bin/env python3
"""Random closed contours under G41 and G42: the tool must touch them wherever it can, and must not cut into them.

  contours_test.py --isogloss PATH [--contours N] [--seed S] [--keep DIR]

Distances are computed from the contour and the moves alone, by formulas that know nothing of compensation: no point of
the path may come nearer to the contour than the radius, and each place from which the tool touches the contour without
cutting another part of it must lie on the path, both to 1e-6 mm. A neck that is too narrow must be reported. LinuxCNC's
rs274, where it is installed, is checked in the same way to 0.02 mm, because it prints four decimals: that tests the
test.
"""
import argparse
import csv
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import budgeted  # noqa: E402: it lies in another folder

import contours
from contours import Arc, Line

PLANES = {"G17": "XYZ", "G18": "ZXY", "G19": "YZX"}  # first and second axis of the plane, and the third
CENTERS = {"X": "I", "Y": "J", "Z": "K"}
VARIANTS = {"lines": "", "arc": 'outer-corner="arc"', "type_b": 'start-up="b"'}


def program(elements, side, plane, tangential, climbs=False, linuxcnc=None):
    first, second, third = PLANES[plane]
    point = lambda p: f"{first}{p.real:.9f} {second}{p.imag:.9f}"
    start = elements[0].start
    outward = (1j if side == "G41" else -1j) * elements[0].direction(0)
    way = -elements[0].direction(0) if tangential else outward
    lines = [f"{plane} G21 G90 G94 G40", f"G00 {point(start + 20 * way)} {third}0",
             f"{linuxcnc or side + ' D1'} G01 {point(start)} F600"]
    for number, e in enumerate(elements):
        end = point(e.end) + (f" {third}{0.5 * number:.9f}" if climbs else "")
        if isinstance(e, Arc):
            out = e.center - e.start
            center = f"{CENTERS[first]}{out.real:.9f} {CENTERS[second]}{out.imag:.9f}"
            lines.append(f"{'G03' if e.ccw else 'G02'} {end} {center}")
        else:
            lines.append(f"G01 {end}")
    leave = elements[-1].direction(1) if tangential else outward
    lines += [f"G40 G01 {point(start + 20 * leave)}", "M30"]
    return "\n".join(lines) + "\n", range(4, 4 + len(elements))


def isogloss_path(isogloss, folder, dialect, text, plane, radius):
    (folder / "contour.nc").write_text(text)
    run = subprocess.run([isogloss, "run", "contour.nc", "-d", dialect, "--dialects", folder, "--emit", "motions",
                          "--format", "csv", "--exact", "--set", f"ToolOffsetTable.1.D={radius}"], cwd=folder,
                         capture_output=True, text=True, timeout=60, check=False)
    first, second = ("p" + axis.lower() for axis in PLANES[plane][:2])
    center = [c.replace("p", "c") for c in (first, second)]
    path, at = [], 0j
    for row in csv.DictReader(run.stdout.splitlines()):
        if not row[first]:
            continue
        to = complex(float(row[first]), float(row[second]))
        if row["event"] == "arc":
            middle = complex(float(row[center[0]]), float(row[center[1]]))
            path.append((int(row["line"]), Arc(at, to, middle, row["ccw"] == "1")))
        else:
            path.append((int(row["line"]), Line(at, to)))
        at = to
    return path, run.stderr


def linuxcnc_path(folder, text):
    numbered = "\n".join(f"N{i} {line}" for i, line in enumerate(text.splitlines(), 1)) + "\n"
    (folder / "in.ngc").write_text(numbered)
    (folder / "fresh.var").write_text("")
    (folder / "tool.tbl").write_text("T1 P1 Z0 D1 ;\n")
    (folder / "out.canon").unlink(missing_ok=True)
    subprocess.run(["rs274", "-t", "tool.tbl", "-v", "fresh.var", "-g", "in.ngc", "out.canon"], cwd=folder,
                   capture_output=True, text=True, timeout=60, check=False, env={**os.environ, "HOME": str(folder)})
    path, at = [], 0j
    for row in (folder / "out.canon").read_text().splitlines():
        call = re.match(r"^\s*\d+\s+N(\d+|\.+)\s+(STRAIGHT_TRAVERSE|STRAIGHT_FEED|ARC_FEED)\((.*)\)", row)
        if not call:
            continue
        line = int(call[1]) if call[1].isdigit() else 0
        numbers = [float(n) for n in call[3].split(",")]
        to = complex(*numbers[:2])
        path.append((line, Arc(at, to, complex(*numbers[2:4]), numbers[4] > 0) if call[2] == "ARC_FEED" else Line(at, to)))
        at = to
    return path


def fault(elements, offset, path, lines, slack):
    """What is wrong with the path, or None."""
    tool = abs(offset)
    moves = [move for line, move in path if line in lines]
    for line, move in path:
        if line not in lines:
            continue
        for k in range(25):
            p = move.at(k / 24)
            near = contours.distance(elements, p)
            if near < tool - slack:
                return f"line {line}: cuts in by {tool - near:.3g} at {p:.6f}"
    for i, places in enumerate(contours.Reach(elements, offset).places):
        for p in places:
            if contours.distance(moves, p) > slack:
                return f"element {i}: the tool could stand at {p:.6f}, the path is {contours.distance(moves, p):.3g} away"
    return None


class Test:
    def __init__(self, isogloss, folder, keep):
        self.isogloss, self.folder, self.keep = isogloss, folder, keep
        self.checked = self.refused = self.compared = self.failed = self.necks = 0
        for name, options in VARIANTS.items():
            (folder / f"{name}.xml").write_text(
                f'<Dialect xmlns="urn:isogloss:dialect:1" name="{name}" title="{name}" extends="fanuc"><Chain>'
                f'<Configure syntax="RadiusCompensationPathSyntax" {options}/></Chain></Dialect>\n')

    def report(self, seed, what, text):
        self.failed += 1
        print(f"seed {seed}: {what}")
        if self.keep:
            self.keep.mkdir(parents=True, exist_ok=True)
            (self.keep / f"{seed}.nc").write_text(text)

    def run(self, seed):
        radius = [0.5, 2, 5, 8][seed % 4]
        elements = contours.random_contour(seed, radius)
        if elements is None:
            return
        for side, offset in (("G41", radius), ("G42", -radius)):
            plane = list(PLANES)[seed // 4 % 3]
            tangential = seed % 2 == 1
            variant = list(VARIANTS)[seed // 2 % 3]
            text, lines = program(elements, side, plane, tangential, climbs=seed % 5 == 0)
            reach = contours.Reach(elements, offset)
            path, said = isogloss_path(self.isogloss, self.folder, variant, text, plane, radius)
            if reach.is_narrow:
                wrong = fault(elements, offset, path, lines, 2e-2)
                if wrong and "cuts in" in wrong and not re.search(r"ISO-04\d\d", said):
                    self.report(seed, f"{side} {variant}: not said: {wrong}", text)
                continue
            if re.search(r"ISO-04\d\d", said):
                if not reach.is_swallowed:
                    self.report(seed, f"{side} {variant}: {said.splitlines()[0]}", text)
                self.refused += 1
                if re.search(r"ISO-046[78]", said):
                    continue  # the path is shown as computed, and said to cut in
            wrong = fault(elements, offset, path, lines, 1e-6)
            self.checked += 1
            if wrong:
                self.report(seed, f"{side} {plane} {variant} radius {radius}: {wrong}", text)
            if shutil.which("rs274") and not reach.is_swallowed and radius >= 2:
                self.compare(seed, elements, side, offset)

    def neck(self, seed):
        """A pocket behind an opening: reported where the tool does not fit through, and only there."""
        rng = random.Random(seed)
        radius, width, depth = rng.uniform(2, 8), rng.uniform(3, 20), rng.uniform(5, 20)
        room = rng.uniform(2.5, 5) * radius
        at = [(-width / 2, depth), (-width / 2, 0), (-width / 2 - room, 0), (-width / 2 - room, -4 * radius),
              (width / 2 + room, -4 * radius), (width / 2 + room, 0), (width / 2, 0), (width / 2, depth)]
        side = rng.choice(["G41", "G42"])
        points = [complex(*p) for p in (at if side == "G41" else reversed(at))]
        elements = [Line(a, b) for a, b in zip(points, points[1:])]
        out = points[-1] + (1 if points[-1].real > 0 else -1) * 3 * radius
        text, lines = program([*elements, Line(points[-1], out)], side, "G17", False)
        _, said = isogloss_path(self.isogloss, self.folder, "lines", text, "G17", radius)
        cut = 2 * radius - width
        found = re.search(rf":{lines[0]}:\d+: \w+: beside this block the tool cuts ([\d.]+) mm .*ISO-0496", said)
        is_wrong = found and width > radius and abs(float(found[1]) - cut) > 1e-3  # else the centre passes the wall
        if bool(found) != (cut > 0.01) or is_wrong:
            self.report(seed, f"a neck of {width} mm, radius {radius}: {found and found[0]}", text)
        self.necks += 1

    def compare(self, seed, elements, side, offset):
        text, lines = program(elements, side, "G17", True, linuxcnc=f"{side}.1 D{2 * abs(offset)}")
        path = linuxcnc_path(self.folder, text)
        feeds = [move for line, move in path]
        if abs(feeds[-1].end - (elements[0].start + 20 * elements[-1].direction(1))) > 1e-3:
            return  # LinuxCNC refuses some contours
        # It names a move by the line that it has read by then: the first and the last feed lead in and out.
        wrong = fault(elements, offset, [(lines[0], move) for move in feeds[2:-1]], lines, 2e-2)
        self.compared += 1
        if wrong:
            self.report(seed, f"rs274 {side}: {wrong}", text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--contours", type=int, default=budgeted(60))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path, help="write programs that fail there")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="isogloss-contours-") as name:
        test = Test(options.isogloss.resolve(), pathlib.Path(name), options.keep)
        for seed in range(options.seed, options.seed + options.contours):
            test.run(seed)
            test.neck(seed)
    print(f"{test.checked} paths checked, {test.refused} with parts out of reach, {test.compared} of rs274 checked, "
          f"{test.necks} necks, {test.failed} wrong")
    return 1 if test.failed or test.checked < options.contours / 4 else 0


if __name__ == "__main__":
    sys.exit(main())
