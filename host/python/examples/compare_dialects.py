#!/usr/bin/env python3
"""Where two dialects make different motions of one program, and which block is the reason.

    compare_dialects.py part.nc fanuc haas

A third run shows what a change of a dialect would do: with --slow, a syntax in Python halves each programmed feed.
"""
import argparse
import sys

import isogloss
import numpy as np


@isogloss.syntax(stage="parsing", reads="Parsing.F", writes="Parsing.F")
def slow(block):
    """Halves each F."""
    block["Parsing.F"] = block["Parsing.F"] / 2


def first_difference(a, b):
    """The place of the first move that differs in kind, line or end; None where there is none."""
    a, b = a.motions[a.is_move()], b.motions[b.is_move()]
    both = min(len(a), len(b))
    same = (a["event"][:both] == b["event"][:both]) & (a["line"][:both] == b["line"][:both])
    same &= np.isclose(a["machine"][:both], b["machine"][:both], atol=1e-6, equal_nan=True).all(axis=1)
    parts = np.flatnonzero(~same)
    if parts.size:
        return int(a["line"][parts[0]])
    if len(a) != len(b):
        return int((a if len(a) > both else b)["line"][both])
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("dialects", nargs=2)
    parser.add_argument("--slow", action="store_true")
    options = parser.parse_args()
    try:
        one, two = (isogloss.run(options.program, dialect=d) for d in options.dialects)
        if options.slow:
            slowed = isogloss.run(options.program, dialect=options.dialects[0], syntaxes=[slow])
            print(f"cutting takes {one.summary['feed_seconds']:.1f} s, at half the feed {slowed.summary['feed_seconds']:.1f} s")
    except isogloss.Error as error:
        sys.exit(str(error))
    line = first_difference(one, two)
    if line is None:
        print("the same motions")
        return 0
    print(f"the motions part at line {line}")
    for dialect in options.dialects:
        for block in isogloss.explain(f"{options.program}:{line}", dialect=dialect):
            print(f"  {dialect}: {block['Sentence']}")
    return 1


if __name__ == "__main__":
    sys.exit(main())
