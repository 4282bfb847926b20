#!/usr/bin/env python3
"""One part, drilled, tapped and contoured on three faces, on the machines in dialects/machines: the tool does the same to
the workpiece on each of them. And the worked numbers of a table A with a table C, and of two heads.

  faces_test.py --isogloss PATH

Machine coordinates are walked forwards to the tip as in tip_test.py, and from there back into the workpiece.
"""
import argparse
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

from tip_test import NATURAL, Machine, distance, minus, times

HERE = pathlib.Path(__file__).resolve().parent
MACHINES = HERE.parents[1] / "dialects" / "machines"
LENGTHS = {1: 95.5, 2: 143.25}
# Where the origin of the part is clamped, in machine coordinates with the rotary axes at zero.
WORK = {"ac-table": (5.0, 5.0, -110.0), "b-head-c-table": (25.0, 20.0, 50.0),
        "bc-table": (5.0, -10.0, -100.0)}


def machine_of(file):
    """The rows of a machine file, the axis nearer the base first."""
    rows = []
    for row in ET.parse(file).getroot().iter():
        if not row.tag.endswith("Axis") or row.get("Place") is None:
            continue
        n = [float(row.get(a, 0)) for a in "XYZ"]
        if not any(n):
            n = list(NATURAL[row.get("name")])
        size = math.hypot(*n)
        point = [float(row.get("Pivot" + a, 0)) for a in "XYZ"]
        rows.append((int(row.get("Order", 1)), (row.get("name"), row.get("Place"), times(1 / size, n), point)))
    machine = Machine.__new__(Machine)
    machine.axes = [axis for _, axis in sorted(rows)]
    machine.letters = [axis[0] for axis in machine.axes]
    machine.signs, machine.zeros = {}, {}  # those of the example machines are 1 and 0
    return machine


def run(isogloss, arguments, folder):
    done = subprocess.run([isogloss, "run", *arguments, "--emit", "motions", "--format", "jsonl", "--exact"],
                          cwd=folder, capture_output=True, text=True, check=False)
    events = [json.loads(line) for line in done.stdout.splitlines()]
    return [e for e in events if e.get("Event") in ("rapid", "feed", "arc")], done.stderr


def lengths_of(program):
    """The tool length in force, by line."""
    length, by_line = 0.0, {}
    for number, line in enumerate(program.read_text().splitlines(), 1):
        for word in line.split():
            if word == "G49":
                length = 0.0
            if word.startswith("H"):
                length = LENGTHS[int(word[1:])]
        by_line[number] = length
    return by_line


def same_on_all(isogloss, folder, fail):
    tools = "".join(f'<Tool id="{h}" H="{length}"/>' for h, length in LENGTHS.items())
    (folder / "tools.xml").write_text(f"<ToolOffsetTable>{tools}</ToolOffsetTable>\n")
    lengths = lengths_of(HERE / "faces.nc")
    seen = {}
    for name, work in WORK.items():
        machine = machine_of(MACHINES / f"{name}.xml")
        settings = [f"--set=IsoCoordinateTable.G54.{a}={c}" for a, c in zip("XYZ", work)]
        settings = [s for setting in settings for s in setting.split("=", 1)]
        events, said = run(isogloss, [HERE / "faces.nc", "-d", "fanuc", "--machine", MACHINES / f"{name}.xml",
                                      "--tools", folder / "tools.xml", *settings], folder)
        if "error" in said or "warning" in said:
            fail(f"{name}: {said}")
        path = []
        for event in events:
            at = event["MachineCoordinate"]
            angles = {a: at.get(a, 0.0) for a in machine.letters}
            tip = machine.in_workpiece(machine.tip([at[a] for a in "XYZ"], angles, lengths[event["Line"]]), angles)
            path.append((event["Line"], event["Event"], minus(tip, list(work)), machine.direction(angles), event))
        seen[name] = path
    (first, path), *others = seen.items()
    worst = 0.0
    # G53.1 moves the machine's rotary axes only, and so the tip, on each machine elsewhere.
    positioning = {n for n, line in enumerate((HERE / "faces.nc").read_text().splitlines(), 1) if "G53.1" in line}
    for name, other in others:
        mine = [p for p in path if p[0] not in positioning]
        theirs = [p for p in other if p[0] not in positioning]
        if len(mine) != len(theirs):
            fail(f"{first} makes {len(mine)} moves, {name} {len(theirs)}")
        for a, b in zip(mine, theirs):
            off = max(distance(a[2], b[2]), distance(a[3], b[3]))
            worst = max(worst, off)
            if a[:2] != b[:2] or off > 1e-6:
                fail(f"{first} and {name} differ:\n  {a}\n  {b}")
                break
    return len(path), worst


WORKED = {
    # oA = oC = (0, 0, -100), W = (0, 0, -50)
    "two tables": ([("A", "table", (0, 0, -100)), ("C", "table", (0, 0, -100))], (0, 0, -50), "A30. C45.",
                   (21.2132, 31.1237, 59.7657)),
    "two tables apart": ([("A", "table", (0, 0, -100)), ("C", "table", (0, 5, -80))], (0, 0, -50), "A30. C45.",
                         (17.6777, 32.3920, 59.0335)),
    # H = 200: the axes meet 200 above the gauge point
    "two heads": ([("C", "head", (0, 0, 200)), ("B", "head", (0, 0, 200))], (0, 0, 0), "B45. C30.",
                  (205.9592, 133.1371, 26.2742)),
    "head and table": ([("B", "head", (0, 0, 200)), ("C", "table", (0, 0, -100))], (0, 0, -50), "B45. C30.",
                       (244.9344, 12.3205, -23.7258)),
}


def worked_numbers(isogloss, folder, fail):
    for name, (axes, work, words, wanted) in WORKED.items():
        rows = "".join(f'<Axis name="{a}" Place="{place}" Order="{i + 1}" PivotX="{p[0]}" PivotY="{p[1]}" '
                       f'PivotZ="{p[2]}"/>' for i, (a, place, p) in enumerate(axes))
        (folder / "machine.xml").write_text(f"<Dependencies><MachineKinematics>{rows}</MachineKinematics>"
                                            "</Dependencies>\n")
        (folder / "worked.nc").write_text(f"G90 G54\nG43.4 H1\nG01 X10. Y20. Z0 {words} F100.\n")
        settings = [s for a, c in zip("XYZ", work) for s in ("--set", f"IsoCoordinateTable.G54.{a}={c}")]
        events, said = run(isogloss, ["worked.nc", "-d", "iso", "--machine", "machine.xml", "--set",
                                      "ToolOffsetTable.1.H=120", *settings], folder)
        at = [events[-1]["MachineCoordinate"][a] for a in "XYZ"] if events else []
        if not at or distance(at, wanted) > 1e-4:
            fail(f"{name}: {at}, wanted {wanted}\n{said}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    options = parser.parse_args()
    failures = []
    with tempfile.TemporaryDirectory(prefix="isogloss-faces-") as name:
        folder = pathlib.Path(name)
        isogloss = options.isogloss.resolve()
        moves, worst = same_on_all(isogloss, folder, failures.append)
        worked_numbers(isogloss, folder, failures.append)
    print("\n".join(failures[:6]))
    print(f"{moves} moves on {len(WORK)} machines, the same in the workpiece to {worst:.2g}; {len(failures)} fail")
    return 1 if failures or moves < 30 else 0


if __name__ == "__main__":
    sys.exit(main())
