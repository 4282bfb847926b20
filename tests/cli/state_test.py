#!/usr/bin/env python3
"""`isogloss state`: what is in force at a line, and the blocks that restore it for a restart.

  state_test.py --isogloss PATH [--lines N] [--every N] [unittest's own options]

Over golden programs, at many lines each: a preamble that is written, followed by the rest of the program, makes the
motions of the whole from there; where none is written, a diagnostic says why and the exit status is 1. The comparison
here knows nothing of the command's own: it runs both programs and reads their motions.
"""
import argparse
import functools
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))

from golden_programs import PROGRAMS, arguments_of, dialect_of, golden_files  # noqa: E402: it lies in another folder

OPTIONS = None
# Least share of the tried lines of the golden programs that a preamble restores: less means that a row was lost.
RESTORED = {"fanuc haas iso mazak syntec": 0.7, "siemens": 0.6, "heidenhain": 0.6, "okuma": 0.6}
MOVES = ("rapid", "feed", "arc")
OF_RUN = ("--zero-moves", "--header", "--summary", "--exact")


def command(*arguments, cwd=None, given=None):
    environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")}
    return subprocess.run([OPTIONS.isogloss, *arguments, *OPTIONS.more], capture_output=True, text=True, timeout=120,
                          check=False, cwd=cwd, env=environment, errors="replace", input=given)


PART = """O0001
G21 G17 G90 G94 G40 G49 G80
G10 L2 P1 X-100. Y-50. Z-200.
T3 M06
G54 S2000 M03
G00 X10. Y20. T4
G43 H3 Z50. M08
G01 Z-5. F300.
G91 X10.
Y10.
G90 X0
G52 X5. Y5.
G01 X1. Y1.
G52 X0 Y0
G68 X0 Y0 R30.
G01 X20. Y5.
X25.
G69
G99 G81 X30. Y30. Z-10. R2. F100.
X40.
G98 X50.
G80
#101=12.5
G01 X#101 F200.
G41 D3 X0 Y60.
X20.
G40 X30.
G20
G01 X2. F10.
G19
G18
M98 P2
WHILE [#102 LT 3] DO1
#102=#102+1
X#102
END1
M30
O0002
G01 X7.
M99
"""
TABLES = ("--set", "ToolOffsetTable.3.H=120", "--set", "ToolOffsetTable.3.D=4")


def same_events(whole, rest):
    """The motions of two runs but for their places."""
    if len(whole) != len(rest):
        return f"{len(whole)} events, and {len(rest)} after the preamble"
    for a, b in zip(whole, rest):
        flat = [{k: v for k, v in e.items() if k not in ("File", "Line")} for e in (a, b)]
        if not near(*flat):
            return f"{a}\n{b}"
    return ""


def near(a, b):
    if isinstance(a, dict):
        return isinstance(b, dict) and a.keys() == b.keys() and all(near(a[k], b[k]) for k in a)
    if isinstance(a, (int, float)) and not isinstance(a, bool):
        return abs(a - b) <= 2e-5 * max(1, abs(a) / 100)
    return a == b


@functools.lru_cache(maxsize=1)  # many lines of one program are tried, one after another
def events_of_the_whole(program, common, run):
    whole = command("run", program.name, *common, *run, cwd=program.parent)
    return [json.loads(line) for line in whole.stdout.splitlines()]


def arguments_of_a_restart(program):
    return [a for a in arguments_of(program) if a not in OF_RUN]


def unsafe(events):
    """What a machinist would not run of the preamble's own events; empty: nothing."""
    moves = [e for e in events if e["Event"] in MOVES]
    for i, event in enumerate(moves):
        if event["Event"] == "arc" or (event["Event"] == "feed" and i + 1 < len(moves)):
            return f"it cuts: {event}"
        if event["Event"] == "feed":
            before, after = moves[i - 1].get("ProgramXyz", {}), event.get("ProgramXyz", {})
            if sum(abs(after[axis] - before.get(axis, 1e9)) > 1e-5 for axis in after) > 1:
                return f"it feeds across: {event}"
    kinds = [e["Event"] for e in events]
    if "spindle" in kinds and "feed" in kinds and kinds.index("spindle") > kinds.index("feed"):
        return "the spindle starts after the feed move"
    if "tool" in kinds and "spindle" in kinds and kinds.index("tool") > kinds.index("spindle"):
        return "the tool is changed while the spindle turns"
    return ""


class State(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)
        (self.path / "part.nc").write_text(PART)

    def state(self, line, *arguments, status=0, dialect="fanuc", program="part.nc"):
        done = command("state", f"{program}:{line}", "-d", dialect, *TABLES, *arguments, cwd=self.path)
        self.assertEqual(done.returncode, status, f"{line} {arguments}\n{done.stdout}\n{done.stderr}")
        return done

    def fields(self, line, *arguments):
        found = json.loads(self.state(line, "--json", *arguments).stdout)
        return found, {row["Path"]: row for row in found["State"]}

    def line_of(self, text):
        return PART.splitlines().index(text) + 1

    def restarted(self, line, *arguments):
        """The events behind the preamble, and the preamble."""
        blocks = self.state(line, "--as-preamble", *arguments).stdout
        rest = self.state(line, "--as-preamble", "--with-rest", *arguments).stdout
        self.assertTrue(rest.startswith(blocks))
        self.assertEqual(rest[len(blocks):], "".join(PART.splitlines(True)[line - 1:]))
        return blocks

    def test_each_value_has_its_unit_title_and_line(self):
        found, rows = self.fields(self.line_of("Y10."))
        self.assertEqual((found["When"], found["Text"], found["Line"]), ("before", "Y10.", 10))
        self.assertEqual(rows["PositioningMode.Mode"]["Value"], "Incremental")
        self.assertEqual(rows["PositioningMode.Mode"]["Line"], 9)
        self.assertEqual(rows["ToolHeightCompensation.Offset_mm"]["Value"], 120)
        self.assertEqual(rows["ToolHeightCompensation.Offset_mm"]["Unit"], "mm")
        self.assertIn("Length in force", rows["ToolHeightCompensation.Offset_mm"]["Title"])
        self.assertEqual(rows["ToolChange.SpindleToolId"]["Line"], 4)
        self.assertNotIn("Parsing.Y", rows)
        text = self.state(self.line_of("Y10.")).stdout
        self.assertRegex(text, r"In force before the block:\n")
        self.assertRegex(text, r"Feedrate\.FeedrateValue +300 mm/min +line 8 ")

    def test_before_and_after_and_a_called_program(self):
        self.assertEqual(self.fields(9)[1]["PositioningMode.Mode"]["Value"], "Absolute")
        self.assertEqual(self.fields(9, "--after")[1]["PositioningMode.Mode"]["Value"], "Incremental")
        found, rows = self.fields(self.line_of("#102=#102+1"), "--pass", "3")
        self.assertEqual(found["Pass"], 3)
        self.assertEqual(self.fields(self.line_of("G01 X#101 F200."))[0]["Variables"],
                         [{"Variable": "#101", "Value": 12.5, "File": "part.nc", "Line": self.line_of("#101=12.5")}])

    def test_a_loop_without_end_is_left_after_its_errors(self):
        part = pathlib.Path(self.path) / "endless.nc"
        part.write_text("N10 G222.5\nX#1\nGOTO 10\nX1\n")
        done = command("state", "endless.nc:4", "-d", "fanuc", "--max-errors", "50", cwd=self.path)
        self.assertEqual(re.findall(r"\[([A-Z]+-\d+)\]", done.stderr), ["ISO-0280", "IG-0517", "IG-0515"], done.stderr)

    def test_a_line_without_a_block(self):
        self.assertIn("[IG-0515]", self.state(999, status=1).stderr)
        self.assertIn("PROGRAM:LINE", command("state", "part.nc", cwd=self.path).stderr)
        self.assertIn("--as-preamble", self.state(5, "--with-rest", status=2).stderr)
        self.state(5, "--as-preamble", "--json", status=2)

    def test_the_preamble_goes_to_the_place_tool_axis_last(self):
        blocks = self.restarted(self.line_of("Y10.")).splitlines()
        self.assertEqual(blocks, ["%", "(RESTART AT LINE 10)", "G21 G17 G90 G94 G40 G49 G80", "G91 G28 Z0", "G90", "G54",
                                  "T3 M06", "T4", "S2000 M03", "G00 X20. Y20.", "G43 H3 G00 Z50.", "M08", "G94 F300.",
                                  "G01 Z-5.", "G01", "G91"])

    def test_rotation_local_offset_variables_inches(self):
        self.assertIn("G52 X5. Y5. Z0.", self.restarted(self.line_of("G01 X1. Y1.")))
        self.assertIn("G68 X0. Y0. R30.", self.restarted(self.line_of("X25.")))
        self.assertIn("#101=12.5\n", self.restarted(self.line_of("G01 X#101 F200.")))
        inches = self.restarted(self.line_of("G19"))
        self.assertIn("G20 G17 ", inches)
        self.assertIn("F10.\n", inches)
        self.assertIn("G00 X2. ", inches)

    def test_changed_tables_are_named(self):
        self.assertRegex(self.state(8, "--as-preamble").stderr, r"note: rows of IsoCoordinateTable .*\[IG-0198\]")

    def test_what_cannot_be_restored_is_reported_and_nothing_written(self):
        for text, reason in (("X20.", "cutter radius compensation has been active since line 25"),
                             ("G01 X7.", "called program")):
            done = self.state(self.line_of(text), "--as-preamble", status=1)
            self.assertRegex(done.stderr, f"{reason}.*\\[IG-0195\\]")
            self.assertEqual(done.stdout, "")
        done = self.state(self.line_of("#102=#102+1"), "--as-preamble", status=1)
        self.assertIn("[IG-0197]", done.stderr)
        self.assertEqual(done.stdout, "")
        (self.path / "scale.nc").write_text("G90 G94 G21\nG00 X10. Y10.\nG51 X0 Y0 I2000 J2000 K1000\nG01 X20. F100.\nM30\n")
        done = self.state(4, "--as-preamble", status=1, program="scale.nc")
        self.assertRegex(done.stderr, r"after the preamble Scaling\.Term is nothing.*\[IG-0196\]")

    def test_a_modal_call_is_not_lost_where_its_macro_moves_to_where_the_tool_stands(self):
        (self.path / "modal.nc").write_text("G21 G90 G54\nG66 P9100\nG00 X10. Y5.\nX30.\nG67\nX40.\nM30\nO9100\nG00 Z50.\nM99\n")
        done = self.state(4, "--as-preamble", status=1, program="modal.nc")
        self.assertIn("modal.nc:9: error: behind the preamble of line 4 this block moves differently", done.stderr)
        self.assertEqual(done.stdout, "")

    def test_what_motions_do_not_show_is_a_warning(self):
        (self.path / "smooth.nc").write_text("G90 G94 G21\nG05.1 Q1\nG01 X20. F100.\nX30.\nM30\n")
        done = self.state(4, "--as-preamble", program="smooth.nc")
        self.assertRegex(done.stderr, r"warning: after the preamble PathSmoothing\..*\[IG-0199\]")
        self.assertIn("G00 X20.", done.stdout)

    def test_what_the_motions_do_not_show_and_the_machine_does_is_an_error(self):
        (self.path / "code.xml").write_text('<MachineCodes><Code name="M88" does="set" fields="Coolant.Mode=THROUGH"/>'
                                            "</MachineCodes>")
        (self.path / "cool.nc").write_text("G90 G94 G21\nM88\nG01 X20. F100.\nX30.\nM30\n")
        done = self.state(4, "--as-preamble", "--machine", "code.xml", program="cool.nc", status=1)
        self.assertRegex(done.stderr, r"Coolant\.Mode is \"OFF\", but before that line it is \"THROUGH\".*\[IG-0196\]")

    def test_a_tool_is_called_as_the_program_names_it(self):
        text = ('G17 G710 G90 G54\nT="ROUGH"\nM6\nT="DRILL 8.5"\nM6\nD1\nT="TAP"\nS1000 M3\nG0 X10 Y10\nG0 Z2\n'
                'G1 Z-5 F100\nX20\nM6\nX5\nT4 M6\nX6\nM30\n')
        blocks = self.lines_of("named.mpf", text, "siemens", 12)
        self.assertIn('T="DRILL 8.5" M6', blocks)
        self.assertIn('T="TAP"', blocks)
        self.assertEqual([b for b in blocks if re.match(r"T\d", b)], [])
        self.assertIn("T4 M6", self.lines_of("named.mpf", text, "siemens", 16))

    def test_an_axis_without_a_position_of_the_program_rests(self):
        klartext = ("0 BEGIN PGM B MM\n1 TOOL CALL 5 Z S2000 F300\n2 L Z+100 R0 FMAX M3\n3 M8\n4 L X+10 R0 FMAX\n"
                    "5 L Z+2 FMAX\n6 L X-20 Y-30 R0 FMAX M91\n7 L Z-1 FMAX M91\n8 L Z+5 F100\n9 M30\n10 END PGM B MM\n")
        (self.path / "b.h").write_text(klartext)
        done = self.state(5, "--as-preamble", dialect="heidenhain", program="b.h")
        self.assertRegex(done.stderr, r"b\.h:5:1: note: the preamble does not move X Y, .*\[IG-0622\]")
        self.assertNotRegex(done.stdout, r"[XY][+-]")
        self.assertIn("L Z+100 R0 FMAX\n", done.stdout)
        self.assertIn("L X+10 R0 FMAX\n", self.state(6, "--as-preamble", dialect="heidenhain", program="b.h").stdout)
        blocks = self.state(9, "--as-preamble", dialect="heidenhain", program="b.h").stdout
        self.assertIn("L X-20 Y-30 R0 FMAX M91\nL Z-1 R0 FMAX M91\n", blocks)
        self.assertNotRegex(blocks, r"L [XYZ].*FMAX\n")
        text = ("O1\nG21 G17 G90 G40 G49 G80\nG91 G28 Z0\nG28 X0 Y0\nG90 G54\nT3 M06\nS2000 M03\nG43 H3\nG00 X10. Y10.\n"
                "Z5.\nG01 Z-2. F200.\nG53 G00 Z-3.\nX50.\nM30\n")
        blocks = self.lines_of("c.nc", text, "fanuc", 9)
        self.assertIn("G28 X0. Y0.", blocks)
        self.assertIn("G43 H3", blocks)
        self.assertEqual([b for b in blocks if re.search("G00.*[XYZ]", b)], [])
        self.assertIn("G53 G00 Z-3.", self.lines_of("c.nc", text, "fanuc", 13))

    def test_a_refusal_names_the_cause_and_what_to_do(self):
        (self.path / "scale.nc").write_text("G90 G94 G21\nG00 X10. Y10.\nG51 X0 Y0 I2000 J2000 K1000\nG01 X20. F100.\nM30\n")
        done = self.state(4, "--as-preamble", status=1, program="scale.nc")
        self.assertRegex(done.stderr, r"scale\.nc:4: error: behind the preamble of line 4 this block moves differently than in "
                         r"the whole program: Scaling\.\S+ is not restored \(line 3: G51 X0 Y0 .*\) \[IG-0197\]")
        self.assertRegex(done.stderr, r"hint: restart at an earlier line, such as a tool change; --nearest finds")

    def test_a_line_behind_a_contour(self):
        """Blocks that waited for the contour end after the line was found."""
        self.state(self.line_of("G41 D3 X0 Y60."), "--as-preamble")
        self.state(self.line_of("G18"), "--as-preamble")

    def test_a_dialect_without_rows_has_no_preamble(self):
        (self.path / "bare.xml").write_text('<Dialect xmlns="urn:isogloss:dialect:1" name="bare" title="Bare" extends="iso">'
                                            '<Dependencies><Remove dependency="ProgramText"/></Dependencies></Dialect>')
        done = self.state(9, "--as-preamble", status=1, dialect="bare.xml")
        self.assertRegex(done.stderr, r"dialect bare does not say how the blocks of a restart are written.*\[IG-0194\]")
        self.state(9, dialect="bare.xml")

    def lines_of(self, name, text, dialect, line, *arguments):
        """The blocks that restore the state before a line of this program."""
        (self.path / name).write_text(text)
        return self.state(line, "--as-preamble", *arguments, dialect=dialect, program=name).stdout.splitlines()

    def test_siemens_writes_its_own_language(self):
        text = ("DEF REAL DEPTH=2.5, HOLES[3]\nDEF INT COUNT\nG17 G710 G90 G54 G0 X0 Y0 Z50\nT1 M6\nR1=4 HOLES[1]=7\n"
                "S1000 M3 F200 FFWON G642\nTRANS X10\nAROT Z30\nASCALE X2 Y2\nAMIRROR Y0\nG0 X10 Y5 Z2\nG1 Z-1 M8\n"
                "X20\nX=R1 Y=HOLES[1]\nMCALL CYCLE81(50,0,2,-DEPTH)\nX40\nX50\nMCALL\nM30\n")
        blocks = self.lines_of("part.mpf", text, "siemens", 14)
        self.assertEqual(blocks[:6], ["; RESTART AT LINE 14", "DEF REAL DEPTH=2.5, HOLES[3]", "G17 G710 G90 G94 G40",
                                      "TRANS", "G0 SUPA Z0 D0", "G54"])
        for block in ("TRANS X10 Y0 Z0", "AROT X0 Y0 Z30", "ASCALE X2 Y2 Z1", "AMIRROR Y0", "R1=4", "HOLES[1]=7", "FFWON", "G642", "M8", "G1 Z-1"):
            self.assertIn(block, blocks)
        self.assertNotIn("DEF INT COUNT", blocks)
        self.assertLess(blocks.index("G0 Z50"), blocks.index("G1 Z-1"))
        self.assertEqual(self.lines_of("part.mpf", text, "siemens", 17)[-1], "MCALL CYCLE81(50,0,2,-DEPTH)")

    def test_heidenhain_writes_its_own_language(self):
        text = ("0 BEGIN PGM PART MM\n1 TOOL CALL 5 Z S2000 F300 DL+0.1\n2 CYCL DEF 247 Q339=+3\n"
                "3 CYCL DEF 7.0 DATUM SHIFT\n4 CYCL DEF 7.1 X+10\n5 CYCL DEF 10.0 ROTATION\n6 CYCL DEF 10.1 ROT+30\n"
                "7 FN 0: Q5 = +4\n8 CYCL DEF 200 DRILLING ~\n  Q200=2 ;SET-UP ~\n  Q201=-20 Q206=150 Q202=5 Q203=0 Q204=50\n"
                "9 CC X+1 Y+2\n10 L X+0 Y+0 Z+50 R0 FMAX M3\n11 L X+Q5 R0 FMAX M8\n12 L X+30 FMAX M99\n"
                "13 L X+Q5 F AUTO M99\n14 M30\n15 END PGM PART MM\n")
        blocks = self.lines_of("part.h", text, "heidenhain", 15, "--set", "IsoCoordinateTable.DATUM_PRESET_3.X=7")
        self.assertEqual(blocks[:5], ["0 BEGIN PGM PART MM", "; RESTART AT LINE 15", "CYCL DEF 247 DATUM SETTING Q339=3",
                                      "L Z+0 R0 FMAX M91", "TOOL CALL 5 Z S2000 F300 DL+0.1 DR+0"])
        for block in ("CYCL DEF 7.1 X+10", "CYCL DEF 10.1 ROT+30", "CC X+1 Y+2", "Q5 = +4", "M8",
                      "8 CYCL DEF 200 DRILLING ~", "  Q200=2 ;SET-UP ~"):
            self.assertIn(block, blocks)

    def test_a_scaling_stands_before_a_shift_in_its_measure(self):
        plane = "PLANE SPATIAL SPA+0 SPB+30 SPC+0 STAY"
        for cycles, order in (
                (("CYCL DEF 11.1 SCL 0.5", plane, "CYCL DEF 7.1 X+10"), ("SCL 0.5", plane, "7.1 X+10")),
                ((plane, "CYCL DEF 7.1 X+10", "CYCL DEF 11.1 SCL 0.5"), (plane, "7.1 X+10", "SCL 0.5")),
                (("CYCL DEF 7.1 X+10", "CYCL DEF 11.1 SCL 0.5"), ("7.1 X+10", "SCL 0.5")),
                (("CYCL DEF 11.1 SCL 0.5", "CYCL DEF 7.1 X+10"), ("7.1 X+5", "SCL 0.5"))):
            lines = ["BEGIN PGM P MM", "TOOL CALL 5 Z S2000 F300", *cycles, "L X+3 Y+4 Z+50 R0 FMAX", "L X+5", "M30",
                     "END PGM P MM"]
            text = "".join(f"{n} {line}\n" for n, line in enumerate(lines))
            said = "\n".join(self.lines_of("p.h", text, "heidenhain", len(lines) - 2))
            places = [said.index(block) for block in order]
            self.assertEqual(places, sorted(places), said)
            self.assertEqual(said.count("SCL"), 1, said)

    def test_a_cycle_of_several_parts_is_repeated_whole(self):
        text = ("0 BEGIN PGM P MM\n1 TOOL CALL 5 Z S2000 F300\n2 CYCL DEF 1.0 PECKING\n3 CYCL DEF 1.1 SET UP 2\n"
                "4 CYCL DEF 1.2 DEPTH -20\n5 CYCL DEF 1.3 PECKG 5\n6 CYCL DEF 1.4 DWELL 0\n7 CYCL DEF 1.5 F100\n"
                "8 L X+0 Y+0 Z+50 R0 FMAX M3\n9 L X+10 FMAX M99\n10 M30\n11 END PGM P MM\n")
        self.assertEqual(self.lines_of("p.h", text, "heidenhain", 10)[-6:], text.splitlines()[2:8])

    def test_okuma_writes_its_own_language(self):
        text = ("G21 G90 G17 G15 H2\nT2 M06\nS900 M3\nG0 X5 Y6\nG56 H2 Z20\nG1 Z-2 F100\nX9\nM2\n")
        blocks = self.lines_of("part.min", text, "okuma", 7, "--set", "IsoCoordinateTable.G54.1P2.X=9", "--set",
                               "ToolOffsetTable.2.H=50")
        self.assertEqual(blocks[1:], ["G21 G17 G90 G94 G40 G80", "G15 H2", "G53", "T2 M06", "S900 M03", "G00 X5. Y6.",
                                      "G56 H2 G00 Z20.", "G94 F100.", "G01 Z-2.", "G01"])

    def test_okuma_restores_where_cycles_return(self):
        text = ("G21 G90 G17 G15 H2\nT2 M06\nS900 M3\nG0 X5 Y6\nZ80\nG71 Z50\nG81 X10 Y10 Z-10 R2 F200 {}\nG80\n"
                "G0 X20 Z90\nG81 X30 Y10 Z-10 R2 F200\nG80\nM2\n")
        for code in ("M53", "M54"):
            blocks = self.lines_of("part.min", text.format(code), "okuma", 9)
            self.assertEqual(blocks[-2:], ["G71 Z50.", code])
        self.assertEqual(self.lines_of("part.min", text.format(""), "okuma", 9)[-1], "G71 Z50.")

    def test_haas_selects_a_work_offset_as_the_program_did(self):
        for code in ("G110", "G154 P30", "G55"):
            blocks = self.lines_of("part.nc", f"G21 G90 G17\n{code}\nG0 X5. Y6. Z7.\nX#4014\nM30\n", "haas", 4)
            self.assertIn(code, blocks)

    def test_the_nearest_line_that_can_be_restored(self):
        for text, nearest in (("X20.", "G41 D3 X0 Y60."), ("G01 X7.", "M98 P2")):
            done = self.state(self.line_of(text), "--as-preamble", "--nearest", "--with-rest")
            number = self.line_of(nearest)
            self.assertRegex(done.stderr, rf"part\.nc:{number}:1: note: .*begins at line {number}.*\[IG-0620\]")
            self.assertTrue(done.stdout.endswith("".join(PART.splitlines(True)[number - 1:])))
        self.assertIn("--as-preamble", self.state(5, "--nearest", status=2).stderr)
        self.assertNotIn("IG-0620", self.state(10, "--as-preamble", "--nearest").stderr)

    def test_a_preamble_that_would_cut_is_not_written(self):
        # A series that returns to the initial level: the cycle can be set without a hole from where the tool stands.
        part = PART.replace("G69\n", "G69 G00 Z50.\n").replace("G99 G81", "G98 G81")
        (self.path / "part.nc").write_text(part)
        (self.path / "rows.xml").write_text('<ProgramText><Block name="restart 31 cycle" when="CannedCycle.Term!=G80" '
                                            'text="G81 Z{CannedCycle.Params.Z} R{CannedCycle.Params.R}"/></ProgramText>')
        done = self.state(self.line_of("X40."), "--as-preamble", "--machine", "rows.xml", status=1)
        self.assertIn("[IG-0621]", done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertIn("R2. K0\n", self.state(self.line_of("X40."), "--as-preamble").stdout)
        self.assertIn("R2. L0\n", self.state(self.line_of("X40."), "--as-preamble", dialect="haas").stdout)

    def test_a_pipe(self):
        done = command("state", "/dev/stdin:8", "-d", "fanuc", *TABLES, "--as-preamble", given=PART)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("G43 H3 G00 Z50.", done.stdout)

    def test_golden_programs_restart_at_many_lines(self):
        # The restarted programs stand beside those that they call, in copies: other tests read the golden ones meanwhile.
        with tempfile.TemporaryDirectory() as folder:
            copies = pathlib.Path(folder, "tests", "programs")
            shutil.copytree(PROGRAMS, copies)
            pathlib.Path(folder, "dialects").symlink_to(PROGRAMS.parents[1] / "dialects")
            self.restart_at_many_lines(copies)

    def restart_at_many_lines(self, copies):
        for family, least in RESTORED.items():
            rnd = random.Random(OPTIONS.seed)
            tried = restored = 0
            programs = [p for p in golden_files(".nc") if dialect_of(p) in family.split()]
            for program in programs[::OPTIONS.every]:
                more = arguments_of_a_restart(program)
                common = ("-d", dialect_of(program), *more)
                lines = program.read_bytes().decode(errors="surrogateescape").splitlines(True)
                numbers = [n for n in range(2, len(lines) + 1) if lines[n - 1].strip()]
                for number in rnd.sample(numbers, min(OPTIONS.lines, len(numbers))):
                    with self.subTest(program=str(program), line=number):
                        copy = copies / program.relative_to(PROGRAMS)
                        outcome = self.restart_golden(copy, common, lines, number)
                        tried, restored = tried + (outcome is not None), restored + bool(outcome)
            print(f"{family}: {restored} of {tried} lines restored")
            if OPTIONS.every == 1:
                self.assertGreater(restored, least * tried)

    def restart_golden(self, program, common, lines, number):
        """True: the line is restored, False: it is refused; None: the run does not come to it."""
        done = command("state", f"{program.name}:{number}", *common, "--as-preamble", cwd=program.parent)
        if done.returncode == 1:
            self.assertRegex(done.stderr, r"\[IG-0(19[4567]|515|621)\]")
            self.assertEqual(done.stdout, "")
            return None if "IG-0515" in done.stderr else False
        self.assertEqual(done.returncode, 0, done.stderr)
        number = int(re.search(r"RESTART AT LINE (\d+)", done.stdout).group(1))  # of a block of several lines the first
        self.compare(program, common, done.stdout, "".join(lines[number - 1:]), number, "IG-0198" in done.stderr)
        return True

    def compare(self, program, common, preamble, rest, number, has_other_tables):
        """The events behind the last one of the preamble's own blocks are the last ones of the whole."""
        run = ("--emit", "motions", "--zero-moves")
        restart = program.with_name("restart-of-this-test.nc")
        restart.write_bytes((preamble + rest).encode(errors="surrogateescape"))
        try:
            of_restart = [a for i, a in enumerate(common) if "--program" not in common[max(i - 1, 0):i + 1]]
            again = command("run", restart.name, *of_restart, *run, cwd=program.parent)
        finally:
            restart.unlink()
        head = preamble.count("\n")
        events = [json.loads(line) for line in again.stdout.splitlines()]
        of_preamble = [i for i, e in enumerate(events) if e["File"] == restart.name and e["Line"] <= head]
        begin = of_preamble[-1] + 1 if of_preamble else 0
        self.assertEqual(unsafe(events[:begin]), "", f"line {number}\n{preamble}")
        # What G10 has set stays in the control; these two runs would begin with other tables.
        if has_other_tables:
            return
        tail = events_of_the_whole(program, common, run)
        after = events[begin:]
        self.assertEqual(same_events(tail[len(tail) - len(after):] if after else [], after), "", f"line {number}\n{preamble}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--lines", type=int, default=3, help="of each golden program")
    parser.add_argument("--every", type=int, default=1, help="of the programs only each Nth: the share is not looked at")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--plugins", help="look for plugins there")
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.isogloss = str(OPTIONS.isogloss.resolve())
    OPTIONS.more = ["--plugins", OPTIONS.plugins] if OPTIONS.plugins else []
    unittest.main(argv=[sys.argv[0], *rest])
