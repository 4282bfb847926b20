#!/usr/bin/env python3
"""What `isogloss explain` answers to the questions of people who read programs: fourteen real ones, and its options.

  explain_test.py --isogloss PATH --source PATH
"""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import unittest

try:
    import jsonschema
except ImportError:
    jsonschema = None

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import FACTOR  # noqa: E402: it lies in another folder

OPTIONS = None

FANUC = """%
O0001
G21 G17 G40 G90 G94
T1 M6
G55
G00 X10. Y5.
G43 H1 Z50.
S1000 M3
G01 Z5. F200.
#101=5.
#102=#101*2
X[#102+1.]
G81 X20. Y20. Z-5. R2. F100.
X30.
G80
G00 X-92. Y-20.
Y-30.
M30
%
"""
OFFSETS = ("--set", "IsoCoordinateTable.G55.X=-161.8", "--set", "ToolOffsetTable.1.H=120")


class Explain(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def write(self, name, text):
        path = self.path / name
        path.write_text(text)
        return path

    def run_it(self, *arguments, status=0):
        environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")}
        done = subprocess.run([OPTIONS.isogloss, "explain", *map(str, arguments)], capture_output=True, text=True,
                              timeout=60, check=False, cwd=self.path, env=environment)
        self.assertEqual(done.returncode, status, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done

    def ask(self, *arguments):
        return self.run_it(*arguments).stdout

    def fanuc(self, line, *more):
        return self.ask(f"{self.write('part.nc', FANUC)}:{line}", "-d", "fanuc", *OFFSETS, *more)

    def golden(self, name):
        return OPTIONS.source / "tests/programs" / name

    def arguments(self, program):
        """What the golden program is run with; its files stand beside it."""
        found = program.with_suffix(".args")
        if not found.exists():
            return []
        words = found.read_text().split()
        return [str(program.parent / w) if (program.parent / w).is_file() else w for w in words]


class Questions(Explain):
    """Fourteen questions that people ask, each with the part of the answer that answers it."""

    def test_01_why_is_this_coordinate_so(self):
        out = self.fanuc(16)
        self.assertIn("Line 16 moves to X-92 Y-20 by rapid, because the line programs G00; machine X is -253.8 because "
                      "G55 adds -161.8 (line 5)", out)
        self.assertRegex(out, r"G55 adds X-161\.8 +-253\.800 +-20\.000 +\S+\n +line 5: G55 \(IsoCoordinateOffsetSyntax\)")

    def test_02_why_a_rapid_without_g00_in_the_line(self):
        self.assertIn("Line 17 moves to Y-30 by rapid, because G00 has been active since line 16", self.fanuc(17))

    def test_03_why_this_feed(self):
        self.assertIn("moves to X11 at 200 mm/min (line 9), because G01 has been active since line 9", self.fanuc(12))
        part = self.write("revs.nc", "G21 G90 G00 X0\nG95 F0.2 S1000 M3\nG01 X30.\nM30\n")
        self.assertIn("at 200 mm/min (from 0.2 mm/rev, line 2)", self.ask(f"{part}:3", "-d", "fanuc"))

    def test_04_who_set_this_plane(self):
        part = self.write("plane.nc", "G21 G90 G00 X0 Y0 Z0\nG18\nG02 X10. Z0 R5. F100.\nM30\n")
        self.assertIn("in plane ZX (G18, line 2)", self.ask(f"{part}:3", "-d", "fanuc"))
        self.assertIn('PlaneSelect.Plane = "ZX" (was "XY")  PlaneSelectSyntax  | G18',
                      self.ask(part, "--field", "PlaneSelect", "-d", "fanuc"))

        part = self.write("again.nc", "G21 G90 G00 X0 Y0\nG17\nG02 X10. Y0 R5. F100.\nM30\n")
        self.assertIn("in plane XY (G17, line 2)", self.ask(f"{part}:3", "-d", "fanuc"))

    def test_05_which_line_of_the_machine_file_answered_this(self):
        tables = self.write("mine.xml", '<Dependencies>\n<IsoCoordinateTable>\n<Offset id="G55" X="-161.8"/>\n'
                            "</IsoCoordinateTable>\n</Dependencies>\n")
        part = self.write("part.nc", FANUC)
        out = self.ask(f"{part}:5", "-d", "fanuc", "--machine", tables)
        self.assertRegex(out, r"row G55 of IsoCoordinateTable, \S*mine\.xml:3")

    def test_06_why_no_motion(self):
        self.assertIn("Line 5 moves nothing: G55 sets CoordinateOffset.Offset_X = -161.8; X now reads ", self.fanuc(5))
        part = self.write("rest.nc", "G21 G17 G90\nG91 G80 T5\nT6\nQX\nM30\n")
        for line, text in ((1, "moves nothing: G21, G17 and G90 are in force already."), (2, 'preselects tool 5; G91 sets PositioningMode.Mode = "Incremental"; G80 is in force from here on.'),
                           (3, "preselects tool 6."), (4, "moves nothing: 'Q' has no number: write its value, or remove the address [ISO-0104].")):
            self.assertIn(f"Line {line} {text}\n", self.run_it(f"{part}:{line}", "-d", "fanuc", "--brief", status=1 if line == 4 else 0).stdout)
        part = self.write("tools.h", "0 BEGIN PGM A MM\n1 TOOL CALL 3 Z S1000\n2 TOOL DEF 5\n3 END PGM A MM\n")
        self.assertEqual(self.ask(f"{part}:3", "-d", "heidenhain", "--brief"), "Line 3 preselects tool 5.\n")
        part = self.write("tools.mpf", 'T="DRILL"\nM6\nM30\n')
        self.assertEqual(self.ask(f"{part}:1", "-d", "siemens", "--brief"), 'Line 1 preselects tool "DRILL", number 1 of this run.\n')
        part = self.write("no.nc", "G21 G90 G00 X0 Y0\nG92 X5.\n/ X9.\nG00 X[\nM30\n")
        self.assertIn("Line 2 moves nothing: X5. belongs to G92", self.ask(f"{part}:2", "-d", "fanuc"))
        self.assertIn("Line 3 moves nothing: the block is skipped",
                      self.ask(f"{part}:3", "-d", "fanuc", "--block-skip", "1"))
        part = self.write("lost.nc", "G21 G90 G00 X0 Y0\nP7. Q3.\nM30\n")
        self.assertIn("moves nothing: no function of this dialect uses P7., Q3.", self.run_it(f"{part}:2", "-d", "fanuc", status=1).stdout)

    def test_07_which_tool_length(self):
        out = self.fanuc(7)
        self.assertIn("machine Z is 170 because G43 adds 120", out)
        self.assertRegex(out, r"G43 adds Z120 +\S+ +\S+ +170\.000\n +line 7: G43 H1 Z50\. \(ToolHeightOffsetSyntax\)")

    def test_08_why_this_radius(self):
        part = self.write("radius.nc", "G21 G90 G17 G00 X0 Y0\nG41 D1 G01 X10. F300.\nX50.\nY40.\nG40 X60. Y60.\nM30\n")
        out = self.ask(f"{part}:4", "-d", "fanuc", "--set", "ToolOffsetTable.1.D=5")
        self.assertIn("the tool left of the path by its radius 5 (line 2)", out)
        self.assertIn("moves the tool centre: feed to X45 Y40 at 300 mm/min, the tool left of the path by its radius 5 (line 2); machine X is 45 because G41 of line 2 adds -5", out)

    def test_09_where_did_this_variable_come_from(self):
        out = self.fanuc(12)
        self.assertRegex(out, r"#102 = 10 +line 11: #102=#101\*2 \(FanucMacroStatementSyntax\)")
        self.assertRegex(self.fanuc(11), r"#101 = 5 +line 10: #101=5\.")

    def test_10_which_program_called_this_and_with_what(self):
        part = self.write("macro.nc", "O1\nG21 G90 G00 X0\nG65 P9000 A5. B2.\nM30\nO9000\n#100=#1+#2\nG01 X[#100] F100.\n"
                          "M99\n")
        self.assertIn("Line 3 sets #1 = 5, #2 = 2; it calls O9000, line 5", self.ask(f"{part}:3", "-d", "fanuc"))
        out = self.ask(f"{part}:6", "-d", "fanuc")
        self.assertRegex(out, r"called O9000 by \S*macro\.nc:3")
        self.assertRegex(out, r"#1 = 5 +line 3: G65 P9000 A5\. B2\. \(FanucMacroCallSyntax\)")
        self.assertIn("X = 7", self.ask(f"{part}:7", "-d", "fanuc"))

    def test_11_why_does_this_stroke_of_a_cycle_end_there(self):
        out = self.fanuc(14)
        self.assertIn("Line 14 makes 4 steps of G81, because G81 has been active since line 13: rapid to X30, rapid to Z2, "
                      "feed to Z-5 at 100 mm/min, rapid to Z5", out)
        self.assertRegex(out, r"feed +30\.000 +20\.000 +-5\.000 +-131\.800 +20\.000 +115\.000  100 mm/min\n"
                         r" +Z is CannedCycle\.Params\.Z \(line 13\)")
        self.assertIn("Z is CannedCycle.Params.R (line 13)", out)

    def test_12_why_is_this_point_of_a_tilted_plane_there(self):
        out = self.ask(f"{self.golden('heidenhain/frames/planes.nc')}:11", "-d", "heidenhain")
        self.assertRegex(out, r"rotation of the plane turns 45° about Y\s+8\.485 +6\.000 +-5\.657\n +line 8: 7 PLANE SPATIAL SPA\+0")
        self.assertIn("local offset adds X10 Y20 Z50", out)
        self.assertRegex(out, r"machine +18\.485 +26\.000 +44\.343")
        machine = self.golden("siemens/frames/swivel.nc")
        out = self.ask(f"{machine}:6", "-d", "siemens", *self.arguments(machine))
        self.assertRegex(out, r"rotation of the plane turns 30° about X and adds X10 Y20\n.*15\.196")
        self.assertIn('line 4: CYCLE800(0,"TABLE"', out)
        part = self.write("tilt.nc", "G21 G90 G17 G54 G00 X0 Y0 Z50.\nG68.2 X100. Y0 Z0 I90. J90. K0\nX10. Y10. Z20.\nM30\n")
        for dialect in ("fanuc", "syntec"):
            with self.subTest(dialect):
                out = self.ask(f"{part}:3", "-d", dialect)
                self.assertRegex(out, r"G68\.2 turns 120° about \(0\.5774 0\.5774 0\.5774\) and adds X100\n"
                                 r" +120\.000 +10\.000 +10\.000\n +line 2: G68\.2")
        part = self.write("turned.nc", "G21 G90 G17 G54 G00 X0 Y0\nG68 X10. Y5. R30.\nX20. Y20.\nM30\n")
        self.assertIn("turns 30° about Z through X10 Y5", self.ask(f"{part}:3", "-d", "fanuc"))

    def test_13_why_do_linear_axes_move_when_rotary_axes_are_programmed(self):
        for name, line, dialect, code in (("fanuc/five_axis/tip_control.nc", 9, "fanuc", "G43.4"),
                                          ("siemens/frames/transformation.nc", 8, "siemens", "tool length compensation")):
            with self.subTest(dialect):
                program = self.golden(name)
                out = self.ask(f"{program}:{line}", "-d", dialect, *self.arguments(program))
                self.assertIn("while rotary axes turn under the tip of the tool", out)
                self.assertRegex(out, rf"{code} adds X42\.426407 Y-42\.426407 Z103\.923048, moving with the rotary axes")
                self.assertRegex(out, r"position of the rotary axes .*, moving with the rotary axes\n +21\.213 +31\.124 +59\.766")
                self.assertIn("rotary axes: A 30.000°  C 45.000°", out)
        part = self.write("m128.h", "0 BEGIN PGM M MM\n1 TOOL CALL 1 Z S1000\n2 L X+10 Y+20 Z+0 R0 FMAX\n3 M128\n"
                          "4 L A+30 C+45 F600\n5 M30\n6 END PGM M MM\n")
        out = self.ask(f"{part}:5", "-d", "heidenhain", "--machine", "ac-table", "--set", "ToolOffsetTable.1.H=120")
        self.assertIn("moves to A30 C45 at 600 mm/min while rotary axes turn under the tip of the tool", out)

    def test_14_who_uses_each_word_of_this_line(self):
        out = self.fanuc(7)
        for word, value, user in (("G43", "G43", "ToolHeightOffsetSyntax"), ("H1", "H = 1", "ToolHeightOffsetSyntax"),
                                  ("Z50.", "Z = 50", "ProgramXyzSyntax")):
            self.assertRegex(out, rf"  {re.escape(word)} +{re.escape(value)} .*\((\w+, then )?{user}\)")
        out = self.ask(f"{self.write('h.h', KLARTEXT)}:5", "-d", "heidenhain")
        self.assertRegex(out, r"X\+Q2 +X = 10 .*\(ProgramXyzSyntax\)")

        out = self.ask(f"{self.write('c.mpf', 'G17 G90 G54 F200 S500 M3')}:1", "-d", "siemens")
        self.assertRegex(out, r"F200 +F = 200 .*\(FeedrateSyntax\)\n")
        out = self.ask(f"{self.write('c.mpf', CYCLE)}:2", "-d", "siemens")
        self.assertRegex(out, r"\n +CYCLE81\.RTP = 20 .*\(SiemensDrillingCycleSyntax\)\n")

    def test_a_code_of_the_initial_state_counts_from_the_line_that_programs_it(self):
        part = self.write("g54.nc", "G21 G90\nG54\nG00 X1.\nM30\n")
        out = self.ask(f"{part}:3", "-d", "fanuc", "--set", "IsoCoordinateTable.G54.X=7")
        self.assertIn("machine X is 8 because G54 adds 7 (line 2)", out)

CYCLE = "G17 G90 G54 F200 S500 M3\nCYCLE81(20,0,2,-10)\nM30\n"
KLARTEXT = """0 BEGIN PGM A MM
1 TOOL CALL 5 Z S2500 F500
2 Q1 = 5
3 Q2 = Q1 * 2
4 L X+Q2 Y+0 R0 FMAX
5 END PGM A MM
"""


class Variables(Explain):
    def test_the_line_that_wrote_a_q_parameter(self):
        program = self.write("q.h", KLARTEXT)
        self.assertRegex(self.ask(f"{program}:5", "-d", "heidenhain"),
                         r"Q2 = 10 +line 4: 3 Q2 = Q1 \* 2 \(KlartextParameterSyntax\)")

    def test_the_line_that_wrote_an_r_parameter_or_a_variable(self):
        program = self.write("r.mpf", "G17 G710 G90 G54\nR1=5\nDEF REAL DEPTH=3\nR2=R1*2\nG0 X=R2+1 Y=DEPTH\nM30\n")
        out = self.ask(f"{program}:5", "-d", "siemens")
        self.assertRegex(out, r"R2 = 10 +line 4: R2=R1\*2 \(\w+\)")
        self.assertRegex(out, r"DEPTH = 3 +line 3: DEF REAL DEPTH=3 \(SiemensDeclarationSyntax\)")

    def test_a_block_says_what_it_wrote(self):
        self.assertIn("Line 11 moves nothing: it sets #102 = 10.", self.fanuc(11))
        block, = json.loads(self.fanuc(11, "--json"))
        self.assertEqual(block["VariablesWritten"], [{"Name": "#102", "Value": 10}])

    def test_a_variable_that_counts_itself_up_was_written_earlier(self):
        part = self.write("count.nc", "#100=1.\n#100=#100+1.\nM30\n")
        self.assertRegex(self.ask(f"{part}:2", "-d", "fanuc"), r"#100 = 1 +line 1: #100=1\. ")

    def test_a_local_variable_belongs_to_its_call(self):
        part = self.write("locals.nc", "O1\n#1=1.\nG65 P2 A7.\n#100=#1\nM30\nO2\n#1=9.\nM99\n")
        self.assertRegex(self.ask(f"{part}:4", "-d", "fanuc"), r"#1 = 1 +line 2: #1=1\.")

    def test_a_variable_that_no_block_wrote(self):
        part = self.write("given.nc", "G21 G90\nG00 X#500\nM30\n")
        table = self.write("v.xml", '<MacroVariables><Variable number="500" Value="3"/></MacroVariables>')
        self.assertRegex(self.ask(f"{part}:2", "-d", "fanuc", "--variables", table), r"#500 = 3 +no block has written it")


MACRO = """O0001
#101=3.
IF [#101 GT 5] GOTO 20
IF [#101 LT 5] GOTO 20
G00 X1.
N20 WHILE [#101 LT 5] DO1
#101=#101+1.
END1
IF [#101 EQ 5] THEN #102=7.
M98 P2 L2
GOTO 90
G00 X2.
N90 M30
O0002
G00 X3.
M99
"""
JUMPS = """N10 R1=3 R2=0
IF R1>5 GOTOF FAR
IF R1<5 GOTOF NEAR
G0 X1
NEAR: R1=R1+1
IF R1<5 GOTOB NEAR
CASE R1 OF 4 GOTOF FAR 5 GOTOF FIVE DEFAULT GOTOF FAR
FIVE:
FOR R3=1 TO 2
R2=R2+R3
ENDFOR
FAR: R4=1
REPEAT FIVE FAR P=1
G0 X9
M30
"""
LABELS = """0 BEGIN PGM L MM
1 Q1 = 3
2 FN 11: IF +Q1 GT +5 GOTO LBL 9
3 FN 12: IF +Q1 LT +5 GOTO LBL 2
4 Q1 = 4
5 LBL 2
6 Q2 = 1
7 CALL LBL 2 REP 2
8 CALL LBL 9
9 M30
10 LBL 9
11 Q3 = 2
12 LBL 0
13 END PGM L MM
"""


class Sentences(Explain):
    """The first sentence is true where something beside the word decides."""

    def test_what_changes_a_programmed_coordinate(self):
        part = self.write("mirror.nc", "G21 G90 G54 G00 X0 Y0\nG51.1 X0\nX20. Y5.\nG50.1 X0\nG16\nG15\nM30\n")
        out = self.ask(f"{part}:2-6", "-d", "fanuc", "--brief").splitlines()
        self.assertIn("Line 3 moves to X-20 Y5 (X20 becomes X-20 by G51.1 of line 2) by rapid", out[1])
        self.assertIn("Line 6 moves nothing: it clears values of PolarCoordinate.", out[4])

    def test_arcs_circles_and_helices(self):
        part = self.write("arc.nc", "G21 G90 G17 G54 G00 X0 Y0 Z0\nG02 X10. Y10. J10. F100.\nG03 I5.\nG03 I5. Z-5.\nM30\n")
        out = self.ask(f"{part}:2-4", "-d", "fanuc", "--brief").splitlines()
        self.assertIn("moves to X10 Y10 on an arc clockwise about X0 Y10, radius 10 in plane XY", out[0])
        self.assertIn("moves on a full circle counter-clockwise about X15 Y10, radius 5", out[1])
        self.assertIn("moves to Z-5 on a helix counter-clockwise about X15 Y10, radius 5", out[2])

    def test_the_spindle_has_its_speed(self):
        part = self.write("s.nc", "G21 G90\nS1200\nM03\nS800\nM05\nM30\n")
        out = self.ask(f"{part}:2-5", "-d", "fanuc", "--brief").splitlines()
        self.assertIn("Line 3 sets the spindle to CW at 1200 rpm (line 2).", out[1])
        self.assertIn("Line 4 sets the spindle to CW at 800 rpm.", out[2])
        self.assertIn("Line 5 sets the spindle to STOP.", out[3])


class Machinists(Explain):
    """What a machine does, told apart from what its display reads."""

    def test_an_axis_that_only_reads_anew_does_not_move(self):
        part = self.write("g55.nc", "G21 G90 G54 G00 X0 Y0\nG43 H1 Z50.\nG55 X10. Y5.\nG54\nG49\nM30\n")
        rows = ("--set", "IsoCoordinateTable.G55.X=-100", "--set", "IsoCoordinateTable.G55.Z=0.03", "--set",
                "ToolOffsetTable.1.H=120.1")
        out = self.ask(f"{part}:3-5", "-d", "fanuc", "--brief", *rows).splitlines()
        self.assertIn("Line 3 moves to X10 Y5 by rapid, ", out[0])
        self.assertIn("; Z now reads 49.97, because G55 adds X-100 Z0.03; the machine stands still in Z; machine X is -90 "
                      "because G55 adds -100", out[0])
        self.assertRegex(out[1], r"moves nothing: .*X now reads -90, Z now reads 50, because G54 replaces G55; "
                         "the machine stands still in X Z")
        self.assertIn("Z now reads 170.1, because G49 replaces G43; the machine stands still in Z", out[2])

    def test_the_first_position_is_a_move(self):
        part = self.write("first.nc", "G21 G90 G54\nG00 X0 Y0\nX0\nM30\n")
        self.assertIn("moves to X0 Y0 by rapid", self.ask(f"{part}:2", "-d", "fanuc", "--brief"))

    def test_rotary_axes_that_a_plane_turns(self):
        part = self.write("plane.h", "0 BEGIN PGM D MM\n1 TOOL CALL 5 Z S2000\n2 L X+0 Y+0 Z+100 R0 FMAX\n"
                          "3 PLANE SPATIAL SPA+0 SPB+30 SPC+0 TURN FMAX\n4 M30\n5 END PGM D MM\n")
        out = self.ask(f"{part}:4", "-d", "heidenhain", "--machine", "ac-table", "--brief")
        self.assertIn("Line 4 moves to A30 C90 by rapid", out)
        self.assertIn("the machine stands still in X Y Z", out)
        program = self.golden("siemens/frames/swivel.nc")
        out = self.ask(f"{program}:4", "-d", "siemens", "--brief", *self.arguments(program))
        self.assertRegex(out, r"Line 4 moves to A-30 C180 by rapid, ")

    def test_a_code_beside_a_comment(self):
        part = self.write("code.nc", "G21 G90\nG21 (MILLIMETRES)\n(A COMMENT)\nG91 (STEPS)\nM30\n")
        out = self.ask(f"{part}:2-4", "-d", "fanuc", "--brief").splitlines()
        self.assertIn("Line 2 moves nothing: G21 is in force already (G20/G21 ", out[0])
        self.assertIn("Line 3 moves nothing: it holds a comment.", out[1])
        self.assertIn('G91 sets PositioningMode.Mode = "Incremental".', out[2])

    def test_each_function_of_a_frame_has_its_own_part(self):
        part = self.write("frame.mpf", "G17 G710 G90 G54\nTRANS X10 Y5\nAROT Z30\nATRANS X2\nASCALE X2 Y2\nG0 X10 Y5 Z2\n"
                          "ROT Z45\nX20\nM30\n")
        out = self.ask(f"{part}:6", "-d", "siemens")
        for does, line in (("ASCALE scales X by 2, Y by 2", 5), ("ATRANS adds X2", 4), ("AROT turns 30° about Z", 3),
                           ("TRANS adds X10 Y5", 2)):
            self.assertRegex(out, rf"{does} +\S+ +\S+ +\S+\n +line {line}: ")
        block, = json.loads(self.ask(f"{part}:6", "-d", "siemens", "--json"))
        functions = block["Ladder"]["Functions"]
        self.assertEqual([f["Name"] for f in functions], ["ASCALE", "ATRANS", "AROT", "TRANS"])
        self.assertEqual([f["Since"]["Line"] for f in functions], [5, 4, 3, 2])
        for axis, value in functions[-1]["Point"].items():
            self.assertAlmostEqual(value, block["Ladder"]["Rungs"][-1]["Point"][axis], 9)
        self.assertIn("AROT turns 30° about Z (line 3)", out)
        out = self.ask(f"{part}:8", "-d", "siemens")
        self.assertIn("ROT turns 45° about Z", out)
        self.assertNotIn("TRANS", out.split("From the program to the machine")[1].split("What the block")[0])
        plane = self.write("plane.h", "0 BEGIN PGM D MM\n1 TOOL CALL 5 Z S2000\n2 PLANE SPATIAL SPA+0 SPB+30 SPC+0 STAY\n"
                           "3 CYCL DEF 7.0 DATUM SHIFT\n4 CYCL DEF 7.1 X+5\n5 CYCL DEF 10.0 ROTATION\n6 CYCL DEF 10.1 ROT+20\n"
                           "7 L X+20 Y+10 R0 FMAX\n8 M30\n9 END PGM D MM\n")
        out = self.ask(f"{plane}:8", "-d", "heidenhain")
        self.assertRegex(out, r"plane frame turns 20° about Z .*\n +line 7: 6 CYCL DEF 10\.1")
        self.assertRegex(out, r"plane frame adds X5 .*\n +line 5: 4 CYCL DEF 7\.1")

    def test_a_program_in_inch_has_both_units(self):
        part = self.write("inch.nc", "G20 G90 G54 G17\nG00 X2. Y1.5\nG43 H1 Z1.\nG01 Z-.25 F10.\nM30\n")
        rows = ("--set", "ToolOffsetTable.1.H=101.6", "--set", "IsoCoordinateTable.G54.X=254")
        out = self.ask(f"{part}:2-4", "-d", "fanuc", "--brief", *rows).splitlines()
        self.assertIn("Line 2 moves to X2 Y1.5 inch (X50.8 Y38.1 mm) by rapid", out[0])
        self.assertIn("machine X is 12 inch (304.8 mm) because G54 adds 10 inch (254 mm) (line 1)", out[0])
        self.assertIn("moves to Z-0.25 inch (Z-6.35 mm) at 10 inch/min (254 mm/min)", out[2])
        out = self.ask(f"{part}:3", "-d", "fanuc", *rows)
        self.assertRegex(out, r"From the program to the machine, in inch: .*\n +program point +2\.0000 +1\.5000 +1\.0000\n")
        self.assertRegex(out, r"machine, in mm +304\.800 +38\.100 +127\.000\n")

    def test_numbers_have_no_noise(self):
        part = self.write("noise.nc", "G21 G90 G54 G00 X0\nG43 H1 Z50.\nG55 X1.\nM30\n")
        out = self.ask(f"{part}:3", "-d", "fanuc", "--set", "IsoCoordinateTable.G55.Z=0.03", "--all")
        self.assertNotRegex(out, r"\d\.\d{7}")

    def test_a_turning_program_has_its_line(self):
        part = self.write("turn.nc", "O1\nG50 S2000\nT0101\nG96 S200 M3\nG71 U2. R1.\nM30\n")
        done = self.run_it(f"{part}:3", "-d", "fanuc", status=1)
        self.assertRegex(done.stderr, r"turn\.nc:2:1: error: .*\[ISO-0540\]")


class SpecialWriters(Explain):
    """Statements that set variables and are no assignments."""

    def written(self, text, name, line, dialect, variable, *more):
        self.assertRegex(self.ask(f"{self.write(name, text)}:{line}", "-d", dialect, *more), variable)

    def test_a_tool_call_and_a_plane_of_a_tnc(self):
        text = ("0 BEGIN PGM A MM\n1 TOOL CALL 5 Z S2500 F500\n2 PLANE SPATIAL SPA+0 SPB+30 SPC+0 STAY\n"
                "3 L X+Q108 Y+Q121 R0 FMAX\n4 QS1 = \"AB\"\n5 QS2 = QS1 || \"C\"\n6 END PGM A MM\n")
        rows = ("--machine", "ac-table", "--set", "ToolOffsetTable.5.D=4", "--set", "ToolOffsetTable.5.H=100")
        self.written(text, "a.h", 4, "heidenhain", r"Q108 = 4 +line 2: 1 TOOL CALL 5 Z S2500 F500 \(KlartextToolCallSyntax\)",
                     *rows)
        self.written(text, "a.h", 4, "heidenhain", r"Q12[01] = .* +line 3: 2 PLANE SPATIAL", *rows)
        self.written(text, "a.h", 6, "heidenhain", r'QS1 = "AB" +line 5: 4 QS1 = ', *rows)

    def test_fills_and_results_of_a_sinumerik(self):
        text = ("DEF REAL A[3]\nDEF REAL B\nA[0]=REP(7)\nR1=A[2]+B\n$AC_MARKER[1]=4\nR2=$AC_MARKER[1]\n"
                "SUB(B)\nR3=B\nM30\n")
        self.write("SUB.spf", "PROC SUB(VAR REAL DEEP)\nDEEP=8\nM17\n")
        self.written(text, "a.mpf", 4, "siemens", r"A\[2\] = 7 +line 3: A\[0\]=REP\(7\)")
        self.written(text, "a.mpf", 4, "siemens", r"B = 0 +line 2: DEF REAL B ")
        self.written(text, "a.mpf", 8, "siemens", r"B = 8 +line 3 of SUB\.spf: M17")


class Flow(Explain):
    """Where the run goes on, and why."""

    def says(self, program, dialect, expected, *more):
        for line, sentence in expected.items():
            with self.subTest(f"{dialect}, line {line}"):
                line, _, number = str(line).partition("/")
                out = self.ask(f"{program}:{line}", "-d", dialect, "--brief", "--pass", number or "1", *more)
                self.assertIn(sentence, out)

    def test_jumps_and_loops_of_a_macro(self):
        part = self.write("macro.nc", MACRO)
        self.says(part, "fanuc", {
            3: "Line 3 goes on with the next block, because [#101 GT 5] does not hold (#101 is 3).",
            4: "Line 4 jumps to line 6 (N20 WHILE [#101 LT 5] DO1), because [#101 LT 5] holds (#101 is 3).",
            6: "Line 6 goes on with the next block, because [#101 LT 5] holds (#101 is 3).",
            "6/3": "Line 6 jumps behind line 8 (END1), because [#101 LT 5] does not hold (#101 is 5).",
            8: "Line 8 jumps back to line 6 (N20 WHILE [#101 LT 5] DO1).",
            9: "Line 9 sets #102 = 7; it goes on with the next block, because [#101 EQ 5] holds (#101 is 5).",
            10: "Line 10 calls line 14 (O0002), 2 times.",
            11: "Line 11 jumps to line 13 (N90 M30).",
            16: "Line 16 begins pass 2 of 2 in line 14 (O0002).",
            "16/2": "Line 16 returns behind the call in line 10."})
        part = self.write("back.nc", "O1\nM98 P2\nG00 X1.\nN40 M30\nO2\nM99 P40\n")
        self.says(part, "fanuc", {6: "Line 6 returns to line 4 (N40 M30), not behind its call in line 2."})
        self.write("O3.nc", "O3\nM99\n")
        part = self.write("other.nc", "O1\nM98 P3\nM30\n")
        self.says(part, "fanuc", {2: "Line 2 calls O3, line 1 of O3.nc (O3)."})
        self.says(part, "fanuc", {2: "Line 2 returns behind the call in line 2 of other.nc."}, "--in", "O3.nc")

    def test_jumps_and_loops_of_a_sinumerik(self):
        self.says(self.write("jumps.mpf", JUMPS), "siemens", {
            2: "Line 2 goes on with the next block, because R1>5 does not hold (R1 is 3).",
            3: "Line 3 jumps to line 5 (NEAR: R1=R1+1), because R1<5 holds (R1 is 3).",
            6: "Line 6 jumps back to line 5 (NEAR: R1=R1+1), because R1<5 holds (R1 is 4).",
            "6/2": "Line 6 goes on with the next block, because R1<5 does not hold (R1 is 5).",
            7: "Line 7 jumps to line 8 (FIVE:), because R1 is 5.",
            9: "Line 9 sets R3 = 1; it goes on with the next block, because R3 = 1 is not above 2.",
            "9/3": "it jumps behind line 11 (ENDFOR), because R3 = 3 is above 2.",
            11: "Line 11 jumps back to line 9 (FOR R3=1 TO 2).",
            13: "Line 13 jumps back to line 8 (FIVE:), because the last repeat follows.",
            "13/2": "Line 13 goes on with the next block, because all repeats are made."})

    def test_a_block_that_waits_for_others_has_no_jump_of_theirs(self):
        """Line 1 waits for the next move in its plane, and the loop in line 8 has begun by then."""
        part = self.write("waits.mpf", "G41 G1 X30 Y30\nMCALL\nCYCLE800(1,\"TC1\",0,57,10,20,0,0,30,0,0,0,0,1,0,1)\nG0 X5 Y5\n"
                                       "TRAORI\nG1 X10 Y10 Z5 B10 C20 F500\nTRAFOOF\nFOR R5=1 TO 3\nG1 X=R5*10\nENDFOR\n")
        self.assertNotIn("jump", self.run_it(f"{part}:1", "-d", "siemens", "--brief", status=1).stdout)
        self.says(part, "siemens", {10: "Line 10 jumps back to line 8 (FOR R5=1 TO 3)"})

    def test_labels_of_a_tnc(self):
        self.says(self.write("labels.h", LABELS), "heidenhain", {
            3: "Line 3 goes on with the next block, because +Q1 GT +5 does not hold (Q1 is 3).",
            4: "Line 4 jumps to line 6 (5 LBL 2), because +Q1 LT +5 holds (Q1 is 3).",
            8: "jumps back to line 6 (5 LBL 2), because a repeat follows, and then 1 more.",
            "8/2": "because the last repeat follows.",
            "8/3": "goes on with the next block, because all repeats are made.",
            9: "calls line 11 (10 LBL 9).",
            13: "returns behind the call in line 9."})

    def test_the_move_that_a_haas_repeats(self):
        part = self.write("l.nc", "G21 G91 G01 F100. X1. L3\nM30\n")
        self.says(part, "haas", {1: "it runs again, because pass 2 of 3 of the block follows",
                                 "1/3": "because all 3 passes of the block are made"})

    @unittest.skipUnless(jsonschema, "no jsonschema")
    def test_json_tells_it_too(self):
        validator = jsonschema.Draft202012Validator(json.loads(
            (OPTIONS.source / "schemas/explain.schema.json").read_text()))
        part = self.write("macro.nc", MACRO)
        blocks = json.loads(self.ask(f"{part}:2-16", "-d", "fanuc", "--json"))
        self.assertEqual([e.message for e in validator.iter_errors(blocks)], [])
        of_line = {b["Line"]: b for b in blocks}
        self.assertEqual(of_line[4]["Conditions"], [{"Text": "[#101 LT 5]", "Holds": True}])
        self.assertEqual((of_line[4]["GoesOn"]["Kind"], of_line[4]["GoesOn"]["Line"]), ("jump", 6))
        self.assertEqual(of_line[3]["GoesOn"], {"Kind": "next"})
        self.assertEqual(of_line[10]["GoesOn"]["Passes"], 2)
        # A range holds the first pass of each line, and O0002 returns in its second.
        self.assertEqual({b["GoesOn"]["Kind"] for b in blocks}, {"next", "jump", "call", "again"})
        [last] = json.loads(self.ask(f"{part}:16", "-d", "fanuc", "--json", "--pass", "2"))
        self.assertEqual([e.message for e in validator.iter_errors([last])], [])
        self.assertEqual(tuple(last["GoesOn"][k] for k in ("Kind", "Line", "CallLine")), ("return", 11, 10))


class Options(Explain):
    def test_brief_is_the_sentence_alone(self):
        self.assertEqual(self.fanuc(17, "--brief").count("\n"), 1)
        self.run_it(f"{self.path / 'part.nc'}:17", "-d", "fanuc", "--brief", "--all", status=2)

    def test_a_range_has_each_line_that_runs(self):
        out = self.fanuc("12-17", "--brief")
        self.assertEqual(re.findall(r"^Line (\d+) ", out, re.M), ["12", "13", "14", "15", "16", "17"])
        part = self.write("sub.nc", "O1\nM98 P2\nX2.\nM30\nO2\nG00 X1.\nM99\n")
        out = self.ask(f"{part}:2-6", "-d", "fanuc", "--brief")
        self.assertEqual(re.findall(r"^Line (\d+) ", out, re.M), ["2", "5", "6", "3", "4"])
        self.assertIn("[IG-0181]", self.run_it(f"{part}:6-2", "-d", "fanuc", status=2).stderr)
        self.assertIn("no block at line 90-95 [IG-0515]", self.run_it(f"{part}:90-95", "-d", "fanuc", status=1).stderr)

    def test_a_loop_without_end_is_left_after_its_errors(self):
        part = self.write("endless.nc", "N10 G222.5\nX#1\nGOTO 10\nX1\n")
        done = self.run_it(f"{part}:4", "-d", "fanuc", "--max-errors", 50, status=1)
        self.assertEqual(re.findall(r"\[([A-Z]+-\d+)\]", done.stderr), ["ISO-0280", "IG-0517", "IG-0515"], done.stderr)

    @unittest.skipIf(FACTOR < 1, "a thousand lines take 20 s there")
    def test_a_range_that_is_too_long_is_cut(self):
        part = self.write("long.nc", "G21 G90\n" + "".join(f"G00 X{i}.\n" for i in range(1500)) + "M30\n")
        done = self.run_it(f"{part}:1-1400", "-d", "fanuc", "--brief")
        self.assertEqual(done.stdout.count("\n"), 1000)
        self.assertIn("only the first 1000 are explained [IG-0182]", done.stderr)

    def test_all_shows_what_was_carried_and_what_slept(self):
        short, out = self.fanuc(17), self.fanuc(17, "--all")
        for text in ("Carried into the block:", "Slept, since nothing that wakes them was set:", "After the block:"):
            self.assertNotIn(text, short)
            self.assertIn(text, out)
        self.assertRegex(out, r"ProgramToMcTransform\[CoordinateOffset\]\.Mat4d = adds X-161\.8 +IsoCoordinateOffsetSyntax")
        self.assertNotRegex(out, r"\[1,0,0,0,")

    def test_a_field_is_followed(self):
        part = self.write("part.nc", FANUC)
        self.assertEqual(self.ask(part, "--field", "Feedrate.FeedrateValue", "-d", "fanuc").splitlines(),
                         [f"{part}:9: Feedrate.FeedrateValue = 200  FeedrateSyntax  | G01 Z5. F200.",
                          f"{part}:13: Feedrate.FeedrateValue = 100 (was 200)  DrillingCycleSyntax  | G81 X20. Y20. Z-5. R2. F100."])
        self.assertEqual(self.ask(part, "--field", "feedratevalue", "-d", "fanuc").count("\n"), 2)
        self.assertEqual(self.ask(f"{part}:10-20", "--field", "FeedrateValue", "-d", "fanuc").count("\n"), 1)
        changes = json.loads(self.ask(part, "--field", "Feedrate", "-d", "fanuc", "--json"))
        self.assertEqual([(c["Line"], c["Path"], c.get("Before"), c["After"], c.get("Writer")) for c in changes],
                         [(0, "Feedrate.Term", None, "G94", None), (0, "Feedrate.Unit", None, "mm/min", None),
                          (9, "Feedrate.FeedrateValue", None, 200, "FeedrateSyntax"),
                          (13, "Feedrate.FeedrateValue", 200, 100, "DrillingCycleSyntax")])
        self.assertIn("ProgramToMcTransform.CoordinateOffset = adds X-161.8",
                      self.ask(part, "--field", "ProgramToMcTransform", "-d", "fanuc", *OFFSETS))

    def test_a_field_that_is_not_there(self):
        part = self.write("part.nc", FANUC)
        done = self.run_it(part, "--field", "Feedrte", "-d", "fanuc", status=2)
        self.assertIn("dialect fanuc has no field or section 'Feedrte' to follow [IG-0180]\n  hint: did you mean Feedrate?",
                      done.stderr)
        done = self.run_it(part, "--field", "Scaling", "-d", "fanuc")
        self.assertIn("no block gives Scaling a value in these lines [IG-0183]", done.stderr)

    @unittest.skipUnless(jsonschema, "no jsonschema")
    def test_json_is_as_its_schema_says(self):
        schema = json.loads((OPTIONS.source / "schemas/explain.schema.json").read_text())
        jsonschema.Draft202012Validator.check_schema(schema)
        validator = jsonschema.Draft202012Validator(schema)
        for arguments in (["--json"], ["--json", "--brief"]):
            blocks = json.loads(self.fanuc("3-18", *arguments))
            self.assertEqual(len(blocks), 16)
            self.assertEqual(list(validator.iter_errors(blocks)), [])
        schema = json.loads((OPTIONS.source / "schemas/explain-field.schema.json").read_text())
        jsonschema.Draft202012Validator.check_schema(schema)
        for field in ("Feedrate", "ProgramToMcTransform", "MotionEvent", "ToolHeightCompensation"):
            changes = json.loads(self.ask(self.path / "part.nc", "--field", field, "-d", "fanuc", "--json", *OFFSETS))
            self.assertGreater(len(changes), 1)
            self.assertEqual(list(jsonschema.Draft202012Validator(schema).iter_errors(changes)), [])
        block = json.loads(self.fanuc(16, "--json"))[0]
        rung = block["Ladder"]["Rungs"][-1]
        self.assertEqual((rung["Source"], rung["Name"], rung["Does"], rung["Since"]["Line"]),
                         ("CoordinateOffset", "G55", "adds X-161.8", 5))
        self.assertEqual(rung["Point"]["X"], block["Ladder"]["MachineCoordinate"]["X"])

    def test_the_way_to_the_machine_ends_at_the_machine(self):
        for name, dialect in (("heidenhain/frames/planes.nc", "heidenhain"), ("iso/frames/tilt.nc", "iso"),
                              ("syntec/frames/tilted.nc", "syntec"), ("fanuc/five_axis/tilt_machining.nc", "fanuc")):
            blocks = json.loads(self.run_any(f"{self.golden(name)}:1-60", "-d", dialect, "--json"))
            compared = 0
            for block in blocks:
                ladder = block["Ladder"]
                moved = block["Document"].get("MotionEvent") or block["Document"].get("CompoundMotion")
                if not ladder.get("Rungs") or "X" not in ladder.get("MachineCoordinate", {}) or not moved:
                    continue
                for axis, value in ladder["Rungs"][-1]["Point"].items():
                    self.assertAlmostEqual(value, ladder["MachineCoordinate"][axis], 6, (name, block["Line"]))
                compared += 1
            self.assertGreater(compared, 1, name)

    def run_any(self, *arguments):
        done = subprocess.run([OPTIONS.isogloss, "explain", *map(str, arguments)], capture_output=True, text=True,
                              timeout=60, check=False)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return done.stdout

    def test_a_late_line_is_answered_soon(self):
        lines = 200_000
        part = self.write("late.nc", "G21 G90 G54 G00 X0 Y0 Z5.\nG01 F500.\n"
                          + "".join(f"X{i % 97}.5 Y{i % 89}.25\n" for i in range(lines)) + "M30\n")
        begin = time.monotonic()
        self.assertIn("because G01 has been active since line 2", self.ask(f"{part}:{lines}", "-d", "fanuc"))
        self.assertLess(time.monotonic() - begin, OPTIONS.seconds)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True)
    parser.add_argument("--source", required=True, type=pathlib.Path)
    parser.add_argument("--seconds", type=float, default=5, help="for a line after 200,000 others")
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.isogloss = str(pathlib.Path(OPTIONS.isogloss).resolve())
    OPTIONS.source = OPTIONS.source.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
