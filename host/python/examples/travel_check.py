#!/usr/bin/env python3
"""Where a program goes, and whether that lies within the travel of a machine.

    travel_check.py part.nc --travel X=-500:0 --travel Z=-400:0 [--dialect fanuc] [--set IsoCoordinateTable.G54.Z=-120]

Exit status 1 when a move ends outside; the first such move of each axis is shown with its line.
"""
import argparse
import sys

import isogloss
import numpy as np

AXES = "XYZABC"


def travel_of(text):
    axis, _, limits = text.partition("=")
    low, _, high = limits.partition(":")
    if axis not in AXES or len(axis) != 1:
        raise argparse.ArgumentTypeError(f"{text}: an axis such as X=-500:0 is needed")
    return AXES.index(axis), float(low), float(high)


def outside(result, travels):
    """(axis, line, position) of the first end of a move beyond each travel."""
    for axis, low, high in travels:
        column = result.positions[:, axis]
        beyond = np.flatnonzero((column < low) | (column > high))  # what is not known is beyond nothing
        if beyond.size:
            yield AXES[axis], int(result.lines[beyond[0]]), float(column[beyond[0]])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--dialect")
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--travel", action="append", type=travel_of, default=[])
    options = parser.parse_args()
    try:
        result = isogloss.run(options.program, dialect=options.dialect, set=options.set)
    except isogloss.Error as error:
        sys.exit(str(error))
    print("machine, arcs with their bulge:")
    for axis, (low, high) in result.summary["machine_extents"].items():
        print(f"  {axis} {low:10.3f} {high:10.3f}")
    found = list(outside(result, options.travel))
    for axis, line, position in found:
        print(f"{result.program}:{line}: {axis} goes to {position:.3f}, beyond its travel")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
