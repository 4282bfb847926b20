#!/usr/bin/env python3
"""`run --emit canonical`: what it writes, read back as ISO, makes the same motions.

  canonical_test.py --isogloss PATH [--corpus DIR] [unittest's own options]

All golden programs, and the real ones of the corpus where there is one ($ISOGLOSS_CORPUS): each event of the program
must come back in its order, with positions to 1e-6 mm, feed, centre, sense and sweep. An arc in a tilted plane comes
back as lines, whose ends must lie on it and whose middles within the tolerance.
"""
import argparse
import json
import math
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "support"), str(HERE.parent / "corpus")]

from golden_programs import arguments_of, dialect_of, golden_files  # noqa: E402: it lies in another folder
from run_corpus import NEAREST, NOT_PROGRAMS  # noqa: E402

OPTIONS = None
WRITTEN = 1.0e-6  # mm and degrees: six decimals, and what adding to a rounded start costs
ARC = 2e-4  # mm: how far a radius that is right to six decimals moves the centre's height
TOLERANCE = 0.001
# The canonical program writes where a rotary axis stands: 370 is another place than 10.
COUNTING_AXES = "<MachineAxes>" + "".join(f'<Axis name="{a}" Rollover="0"/>' for a in "ABC") + "</MachineAxes>"
MOVES = ("rapid", "feed", "arc")


def command(*arguments, cwd=None):
    environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")}
    return subprocess.run([OPTIONS.isogloss, *arguments, *OPTIONS.more], capture_output=True, text=True, timeout=120,
                          check=False, cwd=cwd, env=environment, errors="replace")


def motions(program, *arguments, cwd=None):
    done = command("run", program, *arguments, "--emit", "motions", "--exact", "--max-diagnostics", "1000000", cwd=cwd)
    if done.returncode not in (0, 1):
        raise RuntimeError(f"exit status {done.returncode}\n{done.stderr}")
    return [json.loads(line) for line in done.stdout.splitlines()]


class Machine:
    """Where the axes stand, as the events tell."""

    def __init__(self):
        self.at = dict.fromkeys("XYZABC", 0.0)

    def goal(self, event):
        return {**self.at, **event.get("MachineCoordinate", {})}

    def way(self, event):
        goal = self.goal(event)
        return max(abs(goal[a] - self.at[a]) for a in goal)


def near(a, b, tolerance=WRITTEN):
    return all(abs(a[k] - b[k]) <= tolerance for k in a)


def vector(point):
    return [point[a] for a in "XYZ"]


def minus(a, b):
    return [p - q for p, q in zip(a, b)]


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


class Comparison:
    """Takes the events of both runs side by side; `faults` says where they part."""

    def __init__(self, program, canonical, left_out):
        skipped = {"end"} | ({"coolant"} if any(one.startswith("coolant") for one in left_out) else set())
        self.program = [e for e in program if e["Event"] not in skipped]
        self.canonical = [e for e in canonical if e["Event"] not in skipped]
        self.faults = []
        self.original, self.read = Machine(), Machine()
        self.next, self.has_moved = 0, False

    def fault(self, event, text):
        self.faults.append(f"line {event['Line']}: {text}\n  {json.dumps(event)}")

    def take(self, *kinds):
        """The next event of the canonical program; moves that rounding has left are passed."""
        while self.next < len(self.canonical):
            event = self.canonical[self.next]
            self.next += 1
            if event["Event"] in MOVES and "arc" not in kinds and event["Event"] != "arc" and \
                    self.read.way(event) <= WRITTEN and event["Event"] not in kinds:
                continue
            return event
        return None

    def run(self):
        for event in self.program:
            if event["Event"] in MOVES:
                self.move(event)
            else:
                self.other(event)
            if self.faults:
                return self.faults
        rest = [e for e in self.canonical[self.next:] if e["Event"] not in MOVES or self.read.way(e) > WRITTEN]
        if rest:
            self.fault(rest[0], "the canonical program goes on")
        return self.faults

    def other(self, event):
        got = self.take()
        if got is None or got["Event"] != event["Event"]:
            return self.fault(event, f"reads back as {got}")
        for key in ("ToolId", "Direction", "Mode", "Time", "Angle_deg", "SpindleSpeed_rpm"):
            if key not in event or (key == "SpindleSpeed_rpm" and event["Direction"] == "STOP"):
                continue
            same = abs(event[key] - got.get(key, math.inf)) <= WRITTEN if isinstance(event[key], float) else \
                event[key] == got.get(key)
            if not same:
                self.fault(event, f"{key} reads back as {got.get(key)}")

    def move(self, event):
        goal, start = self.original.goal(event), dict(self.original.at)
        kind = event["Event"]
        if kind != "arc" and self.original.way(event) <= WRITTEN and not near(self.read.at, goal, 2 * WRITTEN):
            return self.fault(event, "nothing moves, but the machine stands elsewhere")
        self.original.at = goal
        steps = self.steps(event, kind, goal)
        self.has_moved = True
        if self.faults:
            return
        if kind == "arc" and "MachineArcCenter" in event:
            self.arc(event, start, goal, steps)
        elif event.get("Form") != "ClLinear" and len(steps) > 1 and kind != "arc":
            self.fault(event, f"{len(steps)} moves in place of one")
        for step in steps:
            if kind == "feed" and event.get("Form") != "ClLinear":
                self.feed(event, step)

    def steps(self, event, kind, goal):
        """The moves of the canonical program up to where this one ends."""
        out, turned = [], 0.0
        wanted = abs(event.get("Sweep_deg", 0.0))
        while True:
            if not out and kind != "arc" and near(goal, self.read.at, 2 * WRITTEN):
                ahead = self.canonical[self.next] if self.next < len(self.canonical) else None
                if ahead is None or ahead["Event"] != kind or self.read.way(ahead) > 2 * WRITTEN:
                    return out
            got = self.take(kind)
            allowed = ("rapid", "feed") if event.get("Form") == "ClLinear" else (kind, "feed") if kind == "arc" else (kind,)
            if got is not None and kind == "arc" and got["Event"] == "rapid" and not out and not self.has_moved:
                self.read.at = self.read.goal(got)  # to where the machine stands before its first block
                continue
            if got is None or got["Event"] not in allowed:
                self.fault(event, f"reads back as {got}")
                return out
            before, self.read.at = dict(self.read.at), self.read.goal(got)
            turned += abs(got.get("Sweep_deg", 0.0))
            out.append((before, got))
            if near(goal, self.read.at, 2 * WRITTEN) and (kind != "arc" or got["Event"] == "feed" or turned > wanted - 1e-3):
                return out

    def feed(self, event, step):
        want, got = event.get("Feedrate_mmds"), step[1].get("Feedrate_mmds")
        if want is not None and (got is None or abs(want - got) > 1e-6 * max(want, 1)):
            self.fault(event, f"the feed reads back as {got}")

    def arc(self, event, start, goal, steps):
        center, normal = vector(event["MachineArcCenter"]), vector(event["Normal"])
        arcs = [s for s in steps if s[1]["Event"] == "arc"]
        axial = max(abs(n) for n in normal) > 1 - 1e-12
        radii = [math.hypot(*minus(vector(p), self.foot(vector(p), center, normal))) for p in (start, goal)]
        if axial and abs(radii[0] - radii[1]) < 4e-4 and abs(event["Sweep_deg"]) > 1 and not arcs:
            return self.fault(event, "an arc in a plane of two axes reads back as lines")
        for before, got in arcs:
            self.feed(event, (before, got))
            turn = got["Sweep_deg"] * dot(vector(got["Normal"]), normal)
            if turn * event["Sweep_deg"] <= 0:
                self.fault(event, "the sense of the arc is another")
            off = minus(vector(got["MachineArcCenter"]), center)
            along = dot(off, normal)
            if math.hypot(*[o - along * n for o, n in zip(off, normal)]) > ARC:
                self.fault(event, f"the centre reads back as {got['MachineArcCenter']}")
        swept = sum(abs(got["Sweep_deg"]) for _, got in arcs)
        if arcs and abs(swept - abs(event["Sweep_deg"])) > 0.01 + math.degrees(4 * WRITTEN / max(radii[0], 1e-6)):
            self.fault(event, f"the sweep reads back as {swept}")
        if arcs:
            return
        for before, got in steps:
            a, b = vector(before), vector(self.read.goal(got) if got is steps[-1][1] else {**before, **got["MachineCoordinate"]})
            for point, off in ((b, 2e-6), ([(p + q) / 2 for p, q in zip(a, b)], TOLERANCE + 2e-6)):
                radius = math.hypot(*minus(point, self.foot(point, center, normal)))
                low, high = sorted(radii)
                if not low - off - 1e-5 <= radius <= high + off + 1e-5:
                    return self.fault(event, f"{point} is {radius} mm from the axis of the arc, not {radii}")

    @staticmethod
    def foot(point, center, normal):
        along = dot(minus(point, center), normal)
        return [c + along * n for c, n in zip(center, normal)]


def left_out(stderr):
    """What the canonical program has no words for, as its diagnostics say."""
    return {part.split(": it is left out")[0] for part in stderr.split("has no word for ")[1:]}


def compare(program, dialect, *arguments, cwd, more=()):
    written = command("run", program, "-d", dialect, *arguments, "--emit", "canonical", *more, cwd=cwd)
    if written.returncode not in (0, 1):
        raise RuntimeError(f"exit status {written.returncode}\n{written.stderr}")
    original = motions(program, "-d", dialect, *arguments, cwd=cwd)
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "canonical.nc"
        path.write_text(written.stdout)
        axes = path.with_name("axes.xml")
        axes.write_text(COUNTING_AXES)
        back = motions(str(path), "-d", "iso", "--machine", str(axes))
    return Comparison(original, back, left_out(written.stderr)).run(), written


class Canonical(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def emit(self, text, *arguments, dialect="fanuc", status=0):
        (self.path / "part.nc").write_text(text)
        done = command("run", "part.nc", "-d", dialect, "--emit", "canonical", *arguments, cwd=self.path)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def same(self, text, *arguments, dialect="fanuc"):
        (self.path / "part.nc").write_text(text)
        faults, written = compare("part.nc", dialect, *arguments, cwd=self.path)
        self.assertEqual(faults, [], written.stdout)
        return written

    def test_blocks_name_their_line_and_are_complete(self):
        lines = self.emit("G21 G54 G00 X1. Y2. Z3.\n\nG01 Z-1.5 F100.\nM30\n").stdout.splitlines()
        self.assertEqual(lines, ["%", "G21 G90 G94 G17 G40 G49 G80", "(part.nc)", "N1 G00 X1. Y2. Z3.",
                                 "N3 G01 X1. Y2. Z-1.5 F100.", "N4 M30", "%"])

    def test_offsets_lengths_and_cycles_are_expanded(self):
        done = self.emit("G55\nG43 H1 G00 X0 Y0 Z50.\nG81 X10. Z-5. R2. F60.\nM30\n", "--set",
                         "IsoCoordinateTable.G55.X=100", "--set", "ToolOffsetTable.1.H=20")
        self.assertIn("N3 G01 X110. Y0. Z15. F60.", done.stdout)
        self.assertNotIn("G81", done.stdout)

    def test_program_coordinates(self):
        text = "G55\nG43 H1 G00 X0 Y0 Z50.\nG01 X10. F60.\nG54\nG01 X20.\nM30\n"
        done = self.emit(text, "--frame", "program", "--set", "IsoCoordinateTable.G55.X=100", "--set",
                         "ToolOffsetTable.1.H=20")
        self.assertIn("N3 G01 X10. Y0. Z50. F60.", done.stdout)
        self.assertIn("N5 G00 X110. Y0. Z50.\nN5 G01 X20. Y0. Z50. F60.", done.stdout)
        self.assertIn("[IG-0191]", done.stderr)

    def test_arcs_of_all_planes_with_radius_helix_and_whole_turns(self):
        self.same("G00 X10. Y0 Z0\nG17 G02 X0 Y-10. R10. F100.\nG03 X10. Y0 R-10.\nG18 G02 X0 Z-10. R10.\n"
                  "G03 X10. Z0 I10. K10. Y4.\nG19 G03 Y-4. J-4. Z8.\nG19 G02 J5. K5.\nG17 G03 I-3. Z20.\nM30\n")

    def test_turns_beside_an_arc_become_circles(self):
        text = "0 BEGIN PGM A MM\n1 L X+20 Y+0 Z+0 R0 FMAX\n2 CC X+0 Y+0\n3 CP IPA+900 IZ-10 DR+ F500\n4 END PGM A MM\n"
        written = self.same(text, dialect="heidenhain")
        self.assertEqual(written.stdout.count("G03"), 3)

    def test_an_arc_in_a_tilted_plane_becomes_lines(self):
        text = ("G00 X0 Y0 Z0\nG68.2 X0 Y0 Z0 I0 J30. K0\nG00 X20. Y0 Z0\nG01 X20. F100.\nG03 X-20. I-20. F200.\nG69\nM30\n")
        coarse = self.same(text).stdout.count("N5 G01")
        self.assertGreater(coarse, 40)
        fine = self.emit(text, "--tolerance", "0.00001").stdout.count("N5 G01")
        self.assertGreater(fine, 5 * coarse)

    def test_a_led_tip_becomes_lines_of_all_axes_in_the_same_time(self):
        """Half of the move, programmed as a block of its own, ends on the lines of the whole move."""
        machine = str(HERE.parent / "programs/fanuc/five_axis/tip_control.machine.xml")
        begin = "G90 G94 G21 G00 X0 Y0 Z50. A0 C0\nG43.4 H1 Z0\n"
        more = ("--machine", machine, "--set", "ToolOffsetTable.1.H=100")
        lines = [shlex.split(block) for block in self.emit(begin + "G01 X40. A30. C60. F600.\nM30\n", *more).stdout.splitlines()
                 if block.startswith("N3 ")]
        self.assertGreater(len(lines), 16)
        points = [{word[0]: float(word[1:]) for word in block} for block in lines]
        (self.path / "part.nc").write_text(begin + "G01 X20. A15. C30. F600.\nX40. A30. C60.\nM30\n")
        start, middle, _ = [e["MachineCoordinate"] for e in motions("part.nc", "-d", "fanuc", *more, cwd=self.path)
                            if e["Event"] != "end"][-3:]
        self.assertTrue(any(near(middle, p) for p in points), middle)
        minutes, before = 0.0, start
        for point in points:
            minutes += math.dist([point[a] for a in "XYZ"], [before[a] for a in "XYZ"]) / point["F"]
            before = point
        self.assertAlmostEqual(minutes, 40 / 600, delta=1e-4)

    def test_feed_modes_and_inches(self):
        written = self.same("G20 G00 X1. Y0 Z0\nG01 X2. F10.\nG93 G01 X3. F2.\nS1000 M03\nG95 G01 X4. F0.01\n"
                            "G04 P1500\nM08\nM09\nM05\nT3 M06\nM00\nM30\n")
        self.assertIn("X50.8 Y0. Z0. F254.", written.stdout)

    def test_a_feed_without_f_and_an_unknown_coolant_are_reported(self):
        done = self.emit("G01 X10.\nM30\n", status=1)
        self.assertIn("[IG-0190]", done.stderr)
        (self.path / "code.xml").write_text('<MachineCodes><Code name="M88" does="set" fields="Coolant.Mode=THROUGH"/>'
                                            "</MachineCodes>")
        done = self.emit("M88\nM30\n", "--machine", "code.xml")
        self.assertRegex(done.stderr, r"no word for coolant THROUGH: it is left out \[IG-0193\]")

    def test_a_user_gives_the_word_for_a_coolant(self):
        row = '<Block name="coolant THROUGH" text="[N{LINE} ]M88"/>'
        (self.path / "words.xml").write_text(f"<ProgramText>{row}</ProgramText>")
        done = self.emit("G00 X1.\nM88\nM89\nM30\n", "--machine", "words.xml", dialect="haas")
        self.assertIn("\nN2 M88\nN3 M09\n", done.stdout)
        self.assertNotIn("IG-0193", done.stderr)
        done = self.emit("G00 X1.\nM88\nM30\n", "--set", "ProgramText.coolant THROUGH.text=M26", dialect="haas")
        self.assertIn("\nM26\n", done.stdout)

    def test_further_axes_are_reported(self):
        (self.path / "u.xml").write_text('<MachineAxes><Axis name="U" Kind="linear"/></MachineAxes>')
        done = command("run", str(HERE.parent / "programs/fanuc/frames/further_axes.nc"), "-d", "fanuc", "--machine",
                       str(HERE.parent / "programs/fanuc/frames/further_axes.xml"), "--emit", "canonical")
        self.assertIn("[ISO-0577]", done.stderr)

    def test_exact_numbers_have_no_exponent(self):
        text = self.emit("G00 X0.0000001 Y0.12345678\nM30\n", "--exact", dialect="iso").stdout
        self.assertIn("N1 G00 X0.0000001 Y0.12345678", text)

    def test_a_row_with_an_open_bracket_is_refused(self):
        for text in ("G00[ X{X}", "G00 {X", "G00 X}", "G00[[ X{X}]]", ""):
            (self.path / "words.xml").write_text(f'<ProgramText><Block name="rapid" text="{text}"/></ProgramText>')
            done = command("run", "-", "-d", "iso", "--machine", "words.xml", cwd=self.path)
            self.assertEqual(done.returncode, 2, text)
            self.assertIn("[IG-0432]", done.stderr)

    def test_wrong_options(self):
        self.assertIn("--tolerance", self.emit("M30\n", "--tolerance", "0", status=2).stderr)
        self.assertIn("--format", self.emit("M30\n", "--format", "csv", status=2).stderr)

    def test_golden_programs_come_back(self):
        count = 0
        for program in golden_files(".nc")[::OPTIONS.every]:
            more = arguments_of(program)
            with self.subTest(program=str(program.relative_to(program.parents[2]))):
                faults, _ = compare(program.name, dialect_of(program), *more, cwd=program.parent)
                self.assertEqual(faults, [])
                count += 1
        self.assertGreater(count, 100 // OPTIONS.every)

    def test_real_programs_come_back(self):
        if not OPTIONS.corpus or not pathlib.Path(OPTIONS.corpus).is_dir():
            self.skipTest("no corpus")
        for folder in sorted(p for p in pathlib.Path(OPTIONS.corpus).iterdir() if p.is_dir()):
            dialect = next(d for d in NEAREST.get(folder.name, ("fanuc",)) if d != "linuxcnc")
            for path in sorted(p for p in folder.rglob("*") if p.is_file() and p.suffix.lower() not in NOT_PROGRAMS):
                if path.stat().st_size > 300_000:
                    continue
                with self.subTest(program=str(path)):
                    faults, _ = compare(str(path), dialect, "--max-errors", "0", cwd=self.path)
                    self.assertEqual(faults, [])


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--corpus", default=os.environ.get("ISOGLOSS_CORPUS"))
    parser.add_argument("--every", type=int, default=1, help="each n-th golden program")
    parser.add_argument("--plugins", help="look for plugins there")
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.isogloss = str(OPTIONS.isogloss.resolve())
    OPTIONS.more = ["--plugins", OPTIONS.plugins] if OPTIONS.plugins else []
    unittest.main(argv=[sys.argv[0], *rest])
