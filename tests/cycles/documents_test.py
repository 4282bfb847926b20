#!/usr/bin/env python3
"""Compares `isogloss apply` with the sequences of reference.py, on documents like the examples of the reference behaviour.

  documents_test.py --isogloss PATH [--cycles G81,G82] [--documents N] [--seed S]

For each cycle N random blocks as CannedCycleResolveSyntax would have left them: the call in Parsing, CannedCycle with
its Params, now and then a plane, a feed in force, a previous block. The whole output must be that of the model, key
for key; sections that the model cannot know (the final state of the spindle) are not checked.
"""
import argparse
import json
import pathlib
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import budgeted  # noqa: E402: it lies in another folder

from cycles_test import CYCLES
from machine import AXIS, PLANES
from random_programs import NEED_Q
from reference import Reference

SYNTAXES = {73: "HighSpeedPeckCycleSyntax", 74: "TappingCycleSyntax", 76: "FineBoringSyntax",
            81: "DrillingCycleSyntax", 82: "DrillingCycleSyntax", 83: "PeckDrillingCycleSyntax",
            84: "TappingCycleSyntax", 85: "BoringCycleSyntax", 86: "BoringCycleSyntax", 87: "BackBoringSyntax",
            88: "ManualBoringCycleSyntax", 89: "BoringCycleSyntax"}
PLANE_NAMES = {17: "XY", 18: "ZX", 19: "YZ"}
UNASKED = ("SpindleSpeed", "SpindleOrientation")


class Document:
    """A block before and after its cycle."""

    def __init__(self, code, rng):
        self.code, self.rng = code, rng
        self.model = model = Reference()
        model.line, model.cycle = 1, code
        model.plane, model.return_to_r = rng.choice((17, 17, 18, 19)), rng.random() < 0.5
        self.previous = {a: self.number(-50, 50) for a in "XYZ"} if rng.random() < 0.7 else None
        model.at = list(self.previous.values()) if self.previous else [0, 0, 0]
        first, second, tool = PLANES[model.plane]
        start = model.at[AXIS[tool]]
        model.level_r = start - self.number(-3, 30)
        model.level_z = model.level_r - self.number(0.5, 25)
        self.hole = {first: self.number(-50, 50), second: self.number(-50, 50)}
        model.peck = self.number(0.5, 12) if code in NEED_Q or rng.random() < 0.1 else None
        model.pause = rng.choice((None, 0.25, 1, 2.5))
        self.feed_in_call = rng.random() < 0.7
        model.feed = rng.randrange(30, 900, 30)
        self.repeats = rng.choice((1, 1, 1, 2, 3))
        self.step = None  # from hole to hole of a repeat, where G91 was in force
        if self.repeats > 1 and rng.random() < 0.7:
            self.step = {first: self.number(-9, 9), second: self.number(-9, 9), tool: 0}

    def number(self, low, high):
        """Quarters: exact in every arithmetic, so that a depth of three times Q is three strokes."""
        return self.rng.randrange(round(low * 4), round(high * 4)) / 4

    def params(self):
        words = {**self.hole, PLANES[self.model.plane][2]: self.model.level_z}
        words = {a: words[a] for a in "XYZ"} | {"R": self.model.level_r}
        optional = {"Q": self.model.peck, "P": self.model.pause}
        return words | {k: v for k, v in optional.items() if v is not None}

    def before(self):
        call = self.params()
        if self.feed_in_call:
            call["F"] = self.model.feed
        if self.repeats > 1:
            call["K"] = self.repeats
        block = {"Parsing": {f"G{self.code}": call},
                 "CannedCycle": {"Term": f"G{self.code}", "ReturnMode": "G99" if self.model.return_to_r else "G98",
                                 "Params": self.params()}}
        if self.step:
            block["CannedCycle"]["Increment"] = {a: self.step[a] for a in "XYZ"}
        if self.model.plane != 17:
            block["PlaneSelect"] = {"Term": f"G{self.model.plane}", "Plane": PLANE_NAMES[self.model.plane]}
        if not self.feed_in_call:
            block["Feedrate"] = self.feedrate()
        return block

    def feedrate(self):
        return {"FeedrateValue": self.model.feed, "Term": "G94", "Unit": "mm/min"}

    def after(self):
        for number in range(self.repeats):
            self.model.drill({a: v + number * (self.step[a] if self.step else 0) for a, v in self.hole.items()})
        block = self.before()
        del block["Parsing"]
        block["Feedrate"] = self.feedrate()
        block["CompoundMotion"] = {"Term": f"G{self.code}", "Items": [item(e) for e in self.model.events]}
        block["ProgramXyz"] = point(self.model.at)
        return block


def point(at):
    return dict(zip("XYZ", map(float, at)))


def item(event):
    if event.kind == "dwell":
        return {"Dwell": {"Time": float(event.value)}}
    if event.kind == "spindle":
        return {"SpindleControl": {"Direction": event.value}}
    if event.kind == "orient":
        return {"SpindleOrientation": {"Angle_deg": 0}}
    motion = {"Form": "McLinear"}
    if event.kind == "rapid":
        motion["IsRapid"] = True
    else:
        motion["Feedrate_mmds"] = float(event.value) / 60
    if event.by_hand:
        motion["IsManual"] = True
    return {"ProgramXyz": point(event.end), "MotionEvent": motion}


def difference(expected, got, path=""):
    """The path of the first difference, with both sides, or None."""
    if isinstance(expected, dict) and isinstance(got, dict):
        for key in [*expected, *(k for k in got if k not in expected)]:
            if not path and key in UNASKED:
                continue
            if key not in expected or key not in got:
                return f"{path}.{key} is {'missing' if key in expected else 'not expected'}"
            what = difference(expected[key], got[key], f"{path}.{key}")
            if what:
                return what
        return None
    if isinstance(expected, list) and isinstance(got, list):
        for index, (a, b) in enumerate(zip(expected, got)):
            what = difference(a, b, f"{path}[{index}]")
            if what:
                return what
        return None if len(expected) == len(got) else f"{path} has {len(got)} items, not {len(expected)}"
    if isinstance(expected, (int, float)) and isinstance(got, (int, float)) and not isinstance(expected, bool):
        return None if abs(expected - got) <= 1e-9 else f"{path} is {got}, not {expected}"
    return None if expected == got else f"{path} is {got!r}, not {expected!r}"


def apply(isogloss, folder, document):
    previous = folder / "previous.json"
    previous.write_text(json.dumps({"ProgramXyz": document.previous} if document.previous else {}))
    command = [isogloss, "apply", SYNTAXES[document.code], "-d", "iso"]
    run = subprocess.run(command + (["--previous", previous] if document.previous else []),
                         input=json.dumps(document.before()), capture_output=True, text=True, check=False)
    if run.returncode != 0:
        return None, f"ends with {run.returncode}: {run.stderr}"
    return json.loads(run.stdout), None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--cycles", default=CYCLES)
    parser.add_argument("--documents", type=int, default=budgeted(25))
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    isogloss = options.isogloss.resolve()
    differing = items = 0
    codes = [int(c.lstrip("G")) for c in options.cycles.split(",")]
    with tempfile.TemporaryDirectory(prefix="isogloss-documents-") as name:
        for code in codes:
            for number in range(options.seed, options.seed + options.documents):
                document = Document(code, random.Random(f"{code} {number}"))
                got, what = apply(isogloss, pathlib.Path(name), document)
                expected = document.after()
                items += len(expected["CompoundMotion"]["Items"])
                what = what or difference(expected, got)
                if what:
                    differing += 1
                    print(f"G{code}, seed {number}: {what}")
                    if differing <= 3:
                        print(f"    previous {document.previous}\n    before {json.dumps(document.before())}\n"
                              f"    expected {json.dumps(expected)}\n    got {json.dumps(got)}")
    print(f"{len(codes) * options.documents} documents, {items} items expected, {differing} documents differ")
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
