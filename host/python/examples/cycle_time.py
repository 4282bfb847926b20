#!/usr/bin/env python3
"""How long each tool of a program is at work, and how much of it is cutting.

    cycle_time.py part.nc [--dialect fanuc] [--machine NAME]

Times are without acceleration; rapid moves need the rapid rates of a machine, and are left out where those are not known.
"""
import argparse
import sys

import isogloss
import numpy as np


def table(result):
    """(tool, cutting s, rapid s, dwell s, feed mm) for each tool, in the order of its first use."""
    tools, seconds, events = result.tools(), np.nan_to_num(result.seconds), result.events
    rows = []
    for tool in dict.fromkeys(tools[result.is_move()].tolist()):
        mine = tools == tool
        cutting = mine & np.isin(events, (isogloss.EVENTS.index("feed"), isogloss.EVENTS.index("arc")))
        rows.append((tool, seconds[cutting].sum(), seconds[mine & (events == 0)].sum(), seconds[mine & (events == 3)].sum(),
                     np.nansum(seconds[cutting] * result.feeds[cutting])))
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--dialect")
    parser.add_argument("--machine")
    options = parser.parse_args()
    try:
        result = isogloss.run(options.program, dialect=options.dialect, machine=options.machine)
    except isogloss.Error as error:
        sys.exit(str(error))
    print(f"{'tool':>6}{'cutting s':>12}{'rapid s':>12}{'dwell s':>12}{'feed mm':>12}")
    for tool, cutting, rapid, dwell, length in table(result):
        name = "none" if tool < 0 else str(tool)
        print(f"{name:>6}{cutting:12.1f}{rapid:12.1f}{dwell:12.1f}{length:12.1f}")
    if np.isnan(result.seconds[result.is_move()]).any():
        print("some moves have no time: the machine's rapid rates, or a feed, are not known", file=sys.stderr)


if __name__ == "__main__":
    main()
