#!/usr/bin/env python3
"""The command line as users see it: what is written to which stream, with which exit status."""
import argparse
import itertools
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import FACTOR, sampled  # noqa: E402: it lies in another folder

OPTIONS = None

PROGRAM = """%
O0001 (A HOLE AND AN ARC)
N10 G21 G90 G17 G54
N20 S1000 M03
G00 X10. Y0. Z5.
G01 Z-1. F120.
G02 X0. Y-10. R10. (QUARTER)
G81 X20. Y20. Z-5. R2. F100.
G80
M30
%
"""


class Command(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)
        self.program = self.write("part.nc", PROGRAM)

    def write(self, name, text):
        path = self.path / name
        path.write_text(text)
        return path

    def run_it(self, *arguments, status=0, given=None, timeout=60, **more):
        environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")} | more.pop("env", {})
        done = subprocess.run([OPTIONS.isogloss, *map(str, arguments)], input=given, capture_output=True, text=True,
                              timeout=timeout, check=False, cwd=self.path, env=environment, **more)
        self.assertEqual(done.returncode, status, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done


class Limits(Command):
    def test_a_block_makes_as_many_holes_as_its_steps_allow(self):
        for cycle, holes in (("G87 X1. Z20. R-95. Q1.", 7692), ("G84 X1. Z-1. R-1. P1", 9090)):
            program = self.write("many.nc", f"M03 S500\nG91 G98 {cycle} F100 K10000\nM30\n")
            done = self.run_it("run", program, "-d", "fanuc", "--emit", "none", status=1)
            self.assertIn(f"only {holes} holes are made [ISO-0352]", done.stderr)
            self.assertNotIn("IG-0405", done.stderr)


class LookAhead(Command):
    """The diagnostics of a run do not depend on whether blocks wait for others at that moment."""

    def said(self, program, *arguments):
        done = subprocess.run([OPTIONS.isogloss, "run", program, "--emit", "none", *arguments], capture_output=True,
                              text=True, timeout=60, check=False, cwd=self.path)
        codes = [line.rsplit("[", 1)[1].rstrip("]") for line in done.stderr.splitlines() if "[IG-04" in line]
        return codes, done.returncode

    def test_every_diagnostic_of_a_run_comes_under_look_ahead(self):
        wide = "(" + "x" * 1_100_000 + ")"
        self.write("O2.nc", "O2\nX20.\nX30.\n")
        self.write("O4.nc", "O7\nX20.\nM99\n")
        for code, rest, *arguments in (
                ("IG-0403", f"X20. {wide}\nX30.\nM30"), ("IG-0404", f"X20. ({wide[-90_000:]}\nX30.\nM30"),
                ("IG-0407", "X20.\nX30.\nX40.\nM30", "--max-blocks", "6"),
                ("IG-0408", "G02 X20. R1.\nX30.\nM30"), ("IG-0412", "X20. \x01\nX30.\nM30"),
                ("IG-0414", "X20.\nM30\nX30."), ("IG-0416", "M98 P1\nM30", "--max-depth", "3"),
                ("IG-0417", "M98 P3 L99\nM30\nO3\nX20.\nM99", "--max-jumps", "5"),
                ("IG-0418", "WHILE[1EQ1]DO1\nX20.\nX10.\nEND1\nM30", "--max-loop-blocks", "10"),
                ("IG-0419", "M98 P2\nM30"), ("IG-0420", "M98 P4\nM30")):
            seen = []
            for mode in ("G40", "G41 D1"):
                program = self.write("main.nc", f"O1\nG21 G90 G17 F100\nG00 X0 Y0\n{mode} G01 X10. Y0\n{rest}\n")
                seen.append(self.said(program, "-d", "fanuc", "--set", "ToolOffsetTable.1.D=0.1", *arguments))
            self.assertIn(code, seen[0][0])
            self.assertEqual(seen[0], seen[1], code)

    def test_every_diagnostic_of_a_run_comes_in_klartext(self):
        wide = "; " + "x" * 1_100_000
        self.write("2.h", "BEGIN PGM 2 MM\nL X+20\n")
        self.write("3.h", "BEGIN PGM 3 MM\nL X+20\nCALL PGM 3\nEND PGM 3 MM\n")
        for code, text, *arguments in (
                ("IG-0403", f"L X+20 {wide}\nL X+30"), ("IG-0404", f"L X+20 {wide[:90_000]}\nL X+30"),
                ("IG-0407", "L X+20\nL X+30\nL X+40", "--max-blocks", "4"),
                ("IG-0416", "CALL PGM 3", "--max-depth", "3"),
                ("IG-0417", "LBL 1\nL X+20\nCALL LBL 1 REP 100", "--max-jumps", "5"),
                ("IG-0418", "LBL 1\nL X+20\nCALL LBL 1 REP 100", "--max-loop-blocks", "10"),
                ("IG-0419", "CALL PGM 2")):
            program = self.write("main.h", f"BEGIN PGM MAIN MM\nL X+0 Y+0 R0 F1000\n{text}\nEND PGM MAIN MM\n")
            codes, status = self.said(program, "-d", "heidenhain", *arguments)
            self.assertIn(code, codes, code)
            self.assertEqual(status, 1 if code in ("IG-0403", "IG-0407", "IG-0416", "IG-0417", "IG-0418")
                             else 0, (code, codes))


class Overflow(Command):
    """A value that is not finite never leaves the engine."""

    def test_an_overflow_is_an_error_at_its_block_in_every_output(self):
        huge = "1" + 308 * "0"
        words = {dialect: f"G91 G0 X{huge}.\nX{huge}.\nM30\n"
                 for dialect in ("iso", "fanuc", "haas", "mazak", "okuma", "siemens", "syntec")}
        words["heidenhain"] = f"BEGIN PGM A MM\nL IX+{huge} F1\nL IX+{huge} F1\nEND PGM A MM\n"
        forms = (("--format", "jsonl"), ("--format", "csv"), ("--format", "text"), ("--emit", "blocks"), ("--summary",))
        for form, dialect in sampled(itertools.product(forms, words)):
            program = self.write("huge.nc", words[dialect])
            done = self.run_it("run", program, "-d", dialect, *form, status=1)
            self.assertIn("[HEI-0182]" if dialect == "heidenhain" else "[IG-0430]", done.stderr)
            for wrong in ("null", "nan", "inf"):
                self.assertNotIn(wrong, done.stdout, (dialect, form))

    def test_the_same_is_said_of_an_overflow_whatever_is_called(self):
        program = self.write("huge.nc", f"O1\nG21 G00 X0 Y0\nX1{308 * '0'}. `\nX30.\nM30\n")
        said = [self.run_it("run", program, "-d", "fanuc", *more, status=1).stderr for more in ((), ("--call-all",))]
        self.assertEqual(said[0], said[1])
        self.assertIn("[ISO-0288]", said[0])

    def test_an_overflow_under_look_ahead_ends_the_run_at_its_block(self):
        huge = "1" + 308 * "0"
        program = self.write("huge.nc", "O1\nG21 G17 F100\nG00 X0 Y0\nG41 D1 G01 X10. Y0\nX20.\n"
                                        f"X{huge}.\nX30.\nM30\n")
        done = self.run_it("run", program, "-d", "fanuc", "--set", "ToolOffsetTable.1.D=1", status=1)
        self.assertIn("huge.nc:6:1: error: MachineCoordinate.X is too large to compute with", done.stderr)
        self.assertEqual([json.loads(line)["Line"] for line in done.stdout.splitlines()], [4, 5])

    def test_a_summary_of_dwells_without_end_is_no_infinity(self):
        program = self.write("dwell.nc", 2 * ("G04 X1" + 308 * "0" + ".\n") + "M30\n")
        text = self.run_it("run", program, "-d", "fanuc", "--summary").stdout
        self.assertNotIn("inf", text)


class ReadErrors(Command):
    """A program that was read in part is not treated as a whole one."""

    def test_a_program_that_becomes_shorter_during_the_run_is_an_error(self):
        program = self.write("part.nc", "G21 G90 F100\n" + "".join(f"G01 X{i}.\n" for i in range(200_000)) + "M30\n")
        read_end, write_end = os.pipe()
        with subprocess.Popen([OPTIONS.isogloss, "run", program, "-d", "fanuc", "--format", "csv"], stdout=write_end,
                              stderr=subprocess.PIPE, text=True, cwd=self.path) as process:
            os.close(write_end)
            os.read(read_end, 100)  # it runs, and waits for its reader
            os.truncate(program, 100_000)
            with os.fdopen(read_end, "rb") as rest:
                rest.read()
            said = process.stderr.read()
        self.assertEqual(process.returncode, 2, said)
        self.assertIn("cannot be read beyond this line (it became shorter during the run)", said)
        self.assertIn("[IG-0431]", said)

    def test_what_cannot_be_read_keeps_an_older_output(self):
        output = self.write("out.csv", "older")
        done = self.run_it("run", "/proc/self/mem", "-d", "fanuc", "-o", output, status=2)
        self.assertIn("Input/output error", done.stderr)
        self.assertEqual(output.read_text(), "older")

    def test_every_output_that_fails_is_2(self):
        for arguments in (("--save-table", "MacroVariables=" + str(self.path / "none" / "x.xml"), "--emit", "none"),
                          ("-o", self.path / "none" / "x.csv")):
            self.assertIn("[IG-0511]", self.run_it("run", self.program, "-d", "fanuc", *arguments, status=2).stderr)
        for arguments in ((), ("-o", self.path / "out.csv")):
            with open("/dev/full", "wb") as full:
                process = subprocess.run([OPTIONS.isogloss, "run", self.program, "-d", "fanuc", "--summary", *arguments],
                                         stdout=full, stderr=subprocess.PIPE, check=False, cwd=self.path)
            self.assertEqual(process.returncode, 2, process.stderr)


class Overwriting(Command):
    def test_no_output_replaces_what_the_run_reads(self):
        text = self.program.read_text()
        table = self.write("kept.xml", '<MacroVariables><Variable id="500" value="1"/></MacroVariables>')
        os.symlink("part.nc", self.path / "link.nc")
        os.link(self.program, self.path / "twin.nc")
        for name in ("part.nc", "./part.nc", "link.nc", "twin.nc"):
            for arguments in (("-o", name), ("--save-table", "MacroVariables=" + name)):
                done = self.run_it("run", "part.nc", "-d", "fanuc", *arguments, status=2)
                self.assertIn("[IG-0530]", done.stderr)
                self.assertEqual(self.program.read_text(), text)
        done = self.run_it("run", "part.nc", "-d", "fanuc", "--variables", table, "-o", "kept.xml", status=2)
        self.assertIn("kept.xml: error: this output would replace", done.stderr)

    def test_two_outputs_are_two_files(self):
        done = self.run_it("run", "part.nc", "-d", "fanuc", "-o", "x", "--save-table", "MacroVariables=./x", status=2)
        self.assertIn("[IG-0531]", done.stderr)
        self.assertFalse((self.path / "x").exists())
        self.run_it("run", "part.nc", "-d", "fanuc", "-o", "/dev/null", "--save-table", "MacroVariables=/dev/null")

    def test_a_link_to_nothing_is_refused(self):
        os.symlink("missing", self.path / "out.csv")
        done = self.run_it("run", "part.nc", "-d", "fanuc", "-o", "out.csv", status=2)
        self.assertIn("it is a link to a file that does not exist [IG-0511]", done.stderr)
        self.assertTrue((self.path / "out.csv").is_symlink())


class BadDocuments(Command):
    def test_deep_and_huge_json_is_an_error_of_the_input(self):
        for text, reason in (('{"a":' * 20_000 + "1" + "}" * 20_000, "nested more than 100 deep"),
                             ('{"A": {' + ",".join(f'"{i}": 0' for i in range(1_000_000)) + "}}", "more than 10000 names"),
                             ('{"Parsing": {"X": 1e999}}', "a number beyond 1.8e308")):
            done = self.run_it("apply", "DwellSyntax", given=text, status=1)
            self.assertIn(reason, done.stderr)
            self.assertIn("[IG-0502]", done.stderr)

    def test_text_for_people_holds_no_control_characters(self):
        program = self.write("red.nc", "G21 (\x1b[31mRED\x07)\nG0 X1. (\x1b]0;TITLE\x07)\nM30\n")
        for emit in ("blocks", "motions"):
            done = self.run_it("run", program, "-d", "fanuc", "--emit", emit, "--format", "text")
            self.assertNotRegex(done.stdout + done.stderr, r"[\x00-\x08\x0b-\x1f\x7f]")
        self.assertIn(r"\x1b[31mRED", self.run_it("run", program, "-d", "fanuc", "--emit", "blocks", "--format",
                                                  "text").stdout)
        done = self.run_it("explain", f"{program}:2", "-d", "fanuc")
        self.assertNotRegex(done.stdout, r"[\x00-\x08\x0b-\x1f\x7f]")

    def test_what_apply_cannot_run(self):
        done = self.run_it("apply", "DwelSyntax", given="{}", status=2)
        self.assertIn("did you mean DwellSyntax", done.stderr)
        self.assertIn("[IG-0504]", done.stderr)
        done = self.run_it("apply", "DwellSyntax", given='{"Parsing": {"G04": {"P": true}}}', status=1)
        self.assertIn("[IG-0503]", done.stderr)

    def test_a_page_without_a_case_is_an_error(self):
        page = self.write("page.md", "nothing of this is a page\n")
        self.assertIn("[IG-0501]", self.run_it("case", page, status=1).stderr)


class Tables(Command):
    def test_what_a_table_does_not_take_is_reported_by_each_command(self):
        wrong = self.write("wrong.xml", '<MacroVariables xmlns="urn:isogloss:dialect:1">\n<Variable number="500" Height="1"/>\n'
                           '<Variable number="501" Width="1"/></MacroVariables>')
        for command in (("run", "part.nc"), ("run", "part.nc", "--summary"), ("explain", "part.nc:3"),
                        ("explain", "part.nc", "--field", "MotionState.Term"), ("state", "part.nc:3"),
                        ("state", "part.nc:7", "--as-preamble"), ("plot", "part.nc"), ("view", "part.nc"),
                        ("diff", "-a", "fanuc", "-b", "haas", "part.nc")):
            for given, code in ((("--variables", wrong), "IG-0219"), (("--set", "Foo.Bar=1"), "IG-0410"),
                                (("--set", "MacroVariables.500.Value=x"), "IG-0411")):
                with self.subTest(command, given=given):
                    named = () if command[0] == "diff" else ("-d", "fanuc")
                    said = self.run_it(*command, *named, *given, status=2).stderr
                    self.assertEqual(said.count(f"[{code}]"), 2 if given[1] == wrong else 1, said)

    """A row that no program can reach is refused by name and line."""

    def refused(self, *arguments, code):
        self.write("part.nc", "G21 G54 G43 H1\nM30\n")
        done = self.run_it("run", "part.nc", "-d", "fanuc", "--emit", "none", *arguments, status=2)
        self.assertIn(f"[{code}]", done.stderr)
        return done.stderr

    def test_rows_that_mean_nothing(self):
        offsets = self.write("offsets.xml", """<Dependencies>
  <IsoCoordinateTable>
    <Offset id="g54" X="100"/>
    <Offset id="G77" X="1"/>
  </IsoCoordinateTable>
  <ToolOffsetTable>
    <Tool id="01" H="1"/>
    <Tool id="abc" H="1"/>
    <Tool id="401" H="1"/>
  </ToolOffsetTable>
</Dependencies>
""")
        said = self.refused("--offsets", offsets, code="IG-0432")
        for line, row in ((3, "g54"), (4, "G77")):
            self.assertRegex(said, rf"offsets.xml:{line}:\d+: error: IsoCoordinateTable has no row '{row}'")
        tools = self.write("tools.xml", offsets.read_text().replace("IsoCoordinateTable", "FanucParameterTable")
                           .replace("Offset id", "Parameter number").replace("g54", "x").replace(' X="100"', ""))
        said = self.refused("--tools", tools, code="IG-0432")
        self.assertRegex(said, r"tools.xml:3:\d+: error: FanucParameterTable has no row 'x'")
        tools.write_text('<ToolOffsetTable>\n<Tool id="01"/>\n<Tool id="401" H="1"/></ToolOffsetTable>')
        said = self.refused("--tools", tools, code="IG-0432")
        self.assertRegex(said, r"tools.xml:2:\d+: error: ToolOffsetTable has no row '01'")
        self.assertRegex(said, r"tools.xml:3:\d+: .* 1 to 400 \(option size\)")

    def test_rows_that_set_fields(self):
        """Each assignment is checked at its cell."""
        faults = (("Cooling.Mode=FLOOD", "IG-0145", "did you mean Coolant.Mode"), ("Dwell.Time=long", "IG-0146", "number"),
                  ("ToolChange.ToolId=1.5", "IG-0146", "integer"), ("PathSmoothing.IsEnabled={P}", "IG-0146", "boolean"),
                  ("ProgramXyz.X=5", "IG-0147", "rows may set"), ("Dwell.Time=500 ms", "IG-0148", "unit: s"))
        for fields, code, text in faults:
            table = self.write("set.xml", f'<MachineCodes>\n<Code name="M131" does="set" fields="{fields}"/></MachineCodes>')
            said = self.refused("--machine", table, code=code)
            self.assertRegex(said, r"set.xml:2:\d+: error: the row 'M131' of MachineCodes")
            self.assertIn(text, said)
        self.refused("--set", "MachineCodes.M131.does=set", "--set", "MachineCodes.M131.fields=Dwell.Tim=5", code="IG-0145")
        own = self.write("own.xml", '''<Dialect xmlns="urn:isogloss:dialect:1" name="own" extends="iso">
  <Dependencies><MachineCodes><Code name="M131" does="set" fields="Vendor.Mode=2"/></MachineCodes></Dependencies>
  <Chain><Configure syntax="MachineCodeFieldSyntax" numbers="Vendor.Mode"/></Chain>
</Dialect>''')
        done = self.run_it("run", "part.nc", "-d", own, "--emit", "none")
        self.assertRegex(done.stderr, r"own.xml:2:\d+: warning: the row 'M131' of MachineCodes sets Vendor.Mode.*\[IG-0149\]")

    def test_rows_of_another_shape(self):
        for text, code in (('<Foo X="1"/>', "IG-0217"), ('<Offset X="1"/>', "IG-0218"),
                           ('<Offset id="G54" Q="1"/>', "IG-0219"), ('<Offset id="G54" X="a"/>', "IG-0220"),
                           ('<Offset id="G54" X="1"/>\n<Offset id="G54" X="2"/>', "IG-0433")):
            table = self.write("rows.xml", f"<IsoCoordinateTable>{text}</IsoCoordinateTable>")
            self.refused("--offsets", table, code=code)

    def test_rows_of_set(self):
        self.refused("--set", "IsoCoordinateTable.G54=5", code="IG-0410")
        for name, hint in (("IsoCordinateTable.G54.X", "did you mean IsoCoordinateTable.G54.X?"),
                           ("IsoCoordinateTable.aditional-sets", "did you mean IsoCoordinateTable.additional-sets?"),
                           ("DwellSyntax.p-unit", "DwellSyntax is a syntax: its options stand in the dialect")):
            done = self.run_it("run", self.program, "-d", "iso", "--set", f"{name}=1", status=2)
            self.assertRegex(done.stderr, rf"\[IG-0410\]\n  hint: {re.escape(hint)}")
        self.refused("--set", "IsoCoordinateTable.g54.X=5", code="IG-0432")
        self.refused("--set", "ToolOffsetTable.0.H=5", code="IG-0432")
        done = self.run_it("run", "part.nc", "-d", "heidenhain", "--set", "HeidenhainDatums.ZERO.D#5.X=10",
                           "--set", "HeidenhainDatums.zero.d#5.X=20", status=2)
        self.assertIn("[IG-0432]", done.stderr)
        for row in ("G504", "G600"):
            done = self.run_it("run", "part.nc", "-d", "siemens", "--set", f"SiemensCoordinateTable.{row}.Z=10", status=2)
            self.assertIn("[IG-0432]", done.stderr)
        self.refused("--set", "IsoCoordinateTable.G54.X=ten", code="IG-0411")
        self.refused("--set", "IsoCoordinateTable.G54.X=+-5", code="IG-0411")
        self.run_it("run", "part.nc", "-d", "fanuc", "--emit", "none", "--set", "FanucParameterTable.3401=1")

    def test_a_table_is_as_long_as_that_of_the_control(self):
        for dialect, text, row in (("siemens", "T500 D1 M6\nG0 Z0\nM30\n", 500),
                                   ("heidenhain", "BEGIN PGM A MM\nTOOL CALL 32000 Z S1\nL Z+0 R0 FMAX\nEND PGM A MM\n",
                                    32000)):
            program = self.write("part.nc", text)
            table = self.write("tool.xml", f'<ToolOffsetTable><Tool id="{row}" H="120"/></ToolOffsetTable>')
            done = self.run_it("run", program, "-d", dialect, "--tools", table)
            self.assertIn('"Z":120', done.stdout, dialect)

    def test_who_gives_values_hears_that_another_one_answers(self):
        rows = '<MachineAxes><Axis name="X" Home="0" Minimum="-500" Maximum="500"/></MachineAxes>'
        dialect = self.write("mine.xml", '<Dialect xmlns="urn:isogloss:dialect:1" name="mine" extends="fanuc">'
                             f"<Dependencies><FanucParameterTable/>{rows}</Dependencies></Dialect>")
        done = self.run_it("run", self.program, "-d", dialect, "--emit", "none")
        self.assertRegex(done.stderr, r"warning: MachineAxes is given values.*FanucParameterTable answers.*\[IG-0434\]")
        done = self.run_it("lint", dialect)
        self.assertIn("isogloss.machine-axis/1: FanucParameterTable answers, not MachineAxes", done.stdout)
        self.assertIn("[IG-0434]", done.stderr)
        services = json.loads(self.run_it("inspect", dialect, "--json").stdout)["Services"]
        self.assertIn({"Service": "isogloss.machine-axis/1", "Answers": "FanucParameterTable",
                       "Not asked": ["MachineAxes"]}, services)
        done = self.run_it("run", self.program, "-d", "fanuc", "--emit", "none", "--set", "MachineAxes.X.Maximum=500")
        self.assertIn("[IG-0434]", done.stderr)
        done = self.run_it("run", self.program, "-d", "fanuc", "--emit", "none", "--set", "MachineAxes.X.Names=XX")
        self.assertNotIn("[IG-0434]", done.stderr, "names are read, whoever answers for positions")

    def test_two_syntaxes_for_one_code(self):
        head = '<Dialect xmlns="urn:isogloss:dialect:1" name="mine" extends="iso"><Chain><InsertAfter ' \
               'syntax="DrillingCycleSyntax"><DrillingCycleSyntax as="Second"%s/></InsertAfter></Chain></Dialect>'
        done = self.run_it("lint", self.write("twice.xml", head % ""), status=1)
        self.assertIn("Second and DrillingCycleSyntax both answer G81, G82", done.stderr)
        self.assertIn("[IG-0241]", done.stderr)
        self.run_it("lint", self.write("twice.xml", head % ' override="true"'))


class OddFiles(Command):
    def test_a_pipe_among_the_dialects_holds_nobody_up(self):
        os.mkfifo(self.path / "pipe.xml")
        self.run_it("list", "dialects", "--dialects", self.path, timeout=20)
        done = self.run_it("lint", self.path / "pipe.xml", status=1, timeout=20)
        self.assertIn("[IG-010", done.stderr)

    def test_a_table_behind_a_link_out_of_the_folder_is_refused(self):
        self.write("secret.xml", '<ToolOffsetTable><Tool id="1" H="5"/></ToolOffsetTable>')
        folder = self.path / "inside"
        folder.mkdir()
        (folder / "tools.xml").symlink_to("../secret.xml")
        dialect = folder / "mine.xml"
        dialect.write_text('<Dialect xmlns="urn:isogloss:dialect:1" name="mine" extends="iso"><Dependencies>'
                           '<ToolOffsetTable src="tools.xml"/></Dependencies></Dialect>')
        self.assertIn("[IG-0117]", self.run_it("lint", dialect, status=1).stderr)

    def test_a_dialect_behind_a_link_out_of_the_folder_is_not_extended(self):
        head = '<Dialect xmlns="urn:isogloss:dialect:1" name="{}" extends="{}"/>'
        self.write("elsewhere.xml", head.format("elsewhere", "iso"))
        folder = self.path / "inside"
        folder.mkdir()
        (folder / "linked.xml").symlink_to("../elsewhere.xml")
        (folder / "beside.xml").write_text(head.format("beside", "iso"))
        for extends, status in (("linked", 1), ("./linked.xml", 1), ("beside", 0)):
            (folder / "mine.xml").write_text(head.format("mine", extends))
            done = self.run_it("lint", folder / "mine.xml", status=status)
            self.assertEqual("[IG-0117]" in done.stderr, status == 1, done.stderr)
        # What stands in a folder that the user names is the user's, links included.
        (folder / "mine.xml").write_text(head.format("mine", "linked"))
        self.run_it("lint", folder / "mine.xml", "--dialects", folder)

    def test_a_hint_out_of_many_names_is_soon_found(self):
        rows = "".join(f'<A{i}x/>' for i in range(20_000))
        table = self.write("many.xml", f"<Dependencies>{rows}</Dependencies>")
        self.run_it("run", self.program, "-d", "fanuc", "--emit", "none", "--tools", table, status=2, timeout=20)

    def test_a_program_in_a_file_of_another_name(self):
        self.write("other.nc", "%\nO1002 (SUB)\nX20.\nM99\n%\n")
        main = self.write("main.nc", "%\nO1\nG21 G90 G0 X0\nM98 P1002\nM98 P1003\nM30\n%\nO1003\nX30.\nM99\n%\n")
        done = self.run_it("run", main, "-d", "fanuc", "--format", "csv")
        self.assertRegex(done.stderr, r"warning: O1002 is called from \S*other.nc.*\[IG-0451\]")
        self.assertEqual([line.split(",")[3] for line in done.stdout.splitlines()[1:3]], ["20", "30"])

    def test_any_number_of_missing_programs_is_soon_not_found(self):
        for number in range(200):
            self.write(f"other{number}.nc", f"O{5000 + number}\n" + "G1 X1. Y1.\n" * 2_000 + "M99\n")
        calls = "".join(f"M98 P{number}\n" for number in range(6000, 7500))
        # The last two are there, however many others were looked for before them.
        main = self.write("main.nc", f"O1\nG21 G90\n{calls}M98 P5150\nM98 P5151\nM30\n")
        done = self.run_it("run", main, "-d", "fanuc", "--emit", "none", "--repeats", "0", status=1, timeout=60)
        self.assertEqual(done.stderr.count("[ISO-0485]"), 1500)
        self.assertRegex(done.stderr, r"O5150 is called from \S*other150.nc.*\[IG-0451\]")
        self.assertRegex(done.stderr, r"O5151 is called from \S*other151.nc.*\[IG-0451\]")

    def test_a_folder_that_is_not_there_is_told(self):
        for option in ("--plugins", "--dialects", "--machines"):
            done = self.run_it("run", self.program, "-d", "fanuc", "--emit", "none", option, self.path / "misspelt")
            self.assertRegex(done.stderr, option + r" names \S*misspelt, which is no folder.* \[IG-0612\]")
            self.assertEqual(done.stderr.count("IG-0612"), 1)
            done = self.run_it("run", self.program, "-d", "fanuc", "--emit", "none", option, self.path)
            self.assertNotIn("IG-0612", done.stderr)
        for variable in ("ISOGLOSS_PLUGIN_PATH", "ISOGLOSS_DIALECT_PATH", "ISOGLOSS_MACHINES"):
            for command in (("run", self.program, "--emit", "none"), ("batch", self.program, "-o", "out-" + variable)):
                done = self.run_it(*command, "-d", "fanuc", env={variable: f"{self.path}:/misspelt"})
                self.assertIn(f"warning: {variable} names /misspelt, which is no folder", done.stderr)
                self.assertEqual(done.stderr.count("IG-0612"), 1)
            result = json.loads((self.path / ("out-" + variable) / "results.jsonl").read_text())
            self.assertNotIn("IG-0612", json.dumps(result))

    def test_an_option_that_the_output_has_no_use_for_is_told(self):
        def told(*options):
            said = self.run_it("run", self.program, "-d", "fanuc", *options).stderr
            return re.findall(r"warning: (--\S+) has no effect: .*\[IG-0519\]", said)
        kept = self.write("kept.csv", "of an earlier run\n")
        self.assertEqual(told("--emit", "none", "--format", "csv", "-o", kept, "--exact"),
                         ["--format", "--output", "--exact"])
        self.assertEqual(kept.read_text(), "of an earlier run\n")
        self.assertEqual(told("--emit", "none", "--json"), ["--json"])
        self.assertEqual(told("--summary", "--json", "--zero-moves"), ["--zero-moves"])
        self.assertEqual(told("--emit", "blocks", "--format", "jsonl", "--header", "--exact"), ["--header", "--exact"])
        self.assertEqual(told("--format", "csv", "--header", "--exact"), ["--header"])
        self.assertEqual(told("--format", "binary", "--exact", "-o", self.path / "a.igm"), ["--exact"])
        self.assertEqual(told("--tolerance", "0.01", "--header"), ["--tolerance"])
        self.assertEqual(told("--emit", "canonical", "--tolerance", "0.01", "--exact", "--zero-moves"), [])
        self.assertEqual(told("--emit", "canonical", "--json"), ["--json"])

    def test_a_number_that_is_too_large_names_the_largest(self):
        said = self.run_it("run", self.program, "--watchdog", "100000000000", status=2).stderr
        self.assertIn("--watchdog: '100000000000' is more than 4294967295", said)
        said = self.run_it("run", self.program, "--max-errors", "1" + "0" * 30, status=2).stderr
        self.assertIn("is more than 18446744073709551615", said)
        self.run_it("run", self.program, "--watchdog", "4294967295", "--max-errors", "18446744073709551615")

    def test_a_rep_for_more_elements_than_are_kept_stores_none(self):
        self.write("few.xml", '<Dialect xmlns="urn:isogloss:dialect:1" name="few" extends="siemens"><Dependencies>'
                              '<SiemensVariables most-variables="8"/></Dependencies></Dialect>')
        # The array and three elements; five more are one too many, and of the next five two are there already.
        main = self.write("main.mpf", "G71 G90 G0 X100\nDEF REAL A[10]\nA[0]=1\nA[1]=1\nA[2]=1\nA[4]=REP(7,5)\nX=A[4]\n"
                                      "A[1]=REP(7,5)\nX=A[5]\nM30\n")
        done = self.run_it("run", main, "-d", self.path / "few.xml", "--format", "csv", status=1)
        self.assertEqual(done.stderr.count("[SIE-0114]"), 1, done.stderr)
        self.assertEqual([line.split(",")[3] for line in done.stdout.splitlines()[1:4]], ["100", "0", "7"])

    def test_a_folder_of_too_many_files_is_told(self):
        for number in range(300):
            self.write(f"other{number}.nc", f"O{5000 + number}\nM99\n")
        main = self.write("main.nc", "O1\nG21 G90\nM98 P5150\nM30\n")
        done = self.run_it("run", main, "-d", "fanuc", "--emit", "none", status=1)
        self.assertRegex(done.stderr, r"O5150 is not found.* folder \S+ \(not inside 30[0-9] files of other names\)")

    def test_a_program_in_a_file_of_another_name_is_found_from_each_caller(self):
        self.write("other.nc", "O1002\nX20.\nM99\n")
        self.write("O1003.nc", "O1003\nM98 P1002\nM99\n")
        main = self.write("main.nc", "O1\nG21 G90 G0 X0\nM98 P1002\nX1.\nM98 P1003\nM30\n")
        done = self.run_it("run", main, "-d", "fanuc", "--format", "csv")
        self.assertEqual([line.split(",")[3] for line in done.stdout.splitlines()[1:4]], ["20", "1", "20"])

    def test_two_files_that_hold_a_program_are_named(self):
        for name in ("a.nc", "b.nc"):
            self.write(name, "O1002\nX20.\nM99\n")
        main = self.write("main.nc", "O1\nG21 G90 G0 X0\nM98 P1002\nM30\n")
        done = self.run_it("run", main, "-d", "fanuc", "--emit", "none", status=1)
        self.assertRegex(done.stderr, r"it is in \S*a.nc and in \S*b.nc: name one file with --subprograms")

    def test_budgets(self):
        program = self.write("long.nc", "G21 G90 F100\n" + "G1 X1.\nX2.\n" * 100_000 + "M30\n")
        done = self.run_it("run", program, "-d", "fanuc", "--max-output", "100000", status=1)
        self.assertIn("stopped after 100000 bytes of output: --max-output sets another limit [IG-0452]", done.stderr)
        self.assertLess(len(done.stdout), 100_001)
        done = self.run_it("run", program, "-d", "fanuc", "--emit", "none", "--max-memory", "1", status=1)
        self.assertIn("[IG-0453]", done.stderr)
        done = self.run_it("run", program, "-d", "fanuc", "--max-motions", "1000", status=1)
        self.assertIn("long.nc:1001:1: error: stopped after 1000 motions: --max-motions sets another limit [IG-0455]",
                      done.stderr)
        self.assertEqual(len(done.stdout.splitlines()), 1000)
        holes = self.write("holes.nc", "G21 G90 F100\nG81 X1. Y1. Z-1. R1. K50\n" + "X2. K50\n" * 50 + "M30\n")
        done = self.run_it("run", holes, "-d", "fanuc", "--emit", "none", "--max-motions", "2000", status=1)
        self.assertIn("[IG-0455]", done.stderr)
        wrong = self.write("wrong.nc", "G21\n" + "G1 X1. F100. E1.\n" * 100_000 + "M30\n")
        done = self.run_it("run", wrong, "-d", "fanuc", "--emit", "none", "--max-diagnostics", "1000", status=1)
        self.assertIn("[IG-0454]", done.stderr)
        errors = self.write("errors.nc", "G21\n" + "G1 X1. Q1. F100.\n" * 200_000 + "M30\n")
        done = self.run_it("run", errors, "-d", "fanuc", "--emit", "none", status=1)
        # A block may report more than one.
        self.assertRegex(done.stderr, r"errors\.nc:\d+: warning: stopped after 10000\d errors: ")
        self.assertLessEqual(int(re.search(r"errors\.nc:(\d+): warning: stopped", done.stderr)[1]), 200_002)

    def test_limits_stop_at_the_first_block_beyond_them(self):
        holes = self.write("limits.nc", "G21 G90 F100\nG0 X0 Y0\nG81 X1. Y1. Z-1. R1.\nX2. K3\nX9.\nG80\nG0 X1.\n"
                           "G83 X1. Z-9. R1. Q2.\nX3.\nX4.\nG80\nM30\n")
        done = self.run_it("run", holes, "-d", "fanuc", "--emit", "blocks")
        blocks = [json.loads(line) for line in done.stdout.splitlines()]
        totals, total = [], 0
        for block in blocks:
            total += 1 + len(block.get("CompoundMotion", {}).get("Items", []))
            totals.append(total)
        self.assertGreater(total, 3 * len(blocks))

        def check(expected, *limits):
            done = self.run_it("run", holes, "-d", "fanuc", "--emit", "blocks", *limits,
                               status=0 if expected == len(blocks) else 1)
            self.assertEqual(len(done.stdout.splitlines()), expected, limits)

        for motions in sampled([*range(1, 12), totals[5], totals[5] - 1, totals[-2], total]):
            by_motions = next((i + 1 for i, t in enumerate(totals) if t > motions), len(blocks))
            check(by_motions, "--max-motions", motions)
            for most in (1, 4, 7):
                check(min(most, by_motions), "--max-motions", motions, "--max-blocks", most)

    def test_diagnostics_go_to_a_file(self):
        wrong = self.write("wrong.nc", "G21\nG200 X1.\nM30\n")
        done = self.run_it("run", wrong, "-d", "fanuc", "--summary", "--diagnostics", "sarif", "--diagnostics-output",
                           "x.sarif", status=1)
        self.assertEqual(done.stderr, "")
        results = json.loads((self.path / "x.sarif").read_text())["runs"][0]["results"]
        self.assertEqual([r["ruleId"] for r in results], ["ISO-0542"])
        done = self.run_it("run", wrong, "-d", "fanuc", "--diagnostics-output", wrong, status=2)
        self.assertIn("[IG-0530]", done.stderr)
        self.assertIn("G200", wrong.read_text())
        self.run_it("run", wrong, "-d", "fanuc", "--diagnostics-output", self.path, status=2)


class Usage(Command):
    def test_help_is_data_with_an_example(self):
        done = self.run_it("--help")
        self.assertIn("Usage: isogloss COMMAND", done.stdout)
        self.assertEqual(done.stderr, "")
        names = [line.split()[0] for line in done.stdout.split("Commands:\n")[1].split("\n\n")[0].splitlines()]
        self.assertEqual(names, ["run", "explain", "state", "batch", "diff", "motions", "plot", "view", "lint", "dialect", "lsp",
                                 "schema", "list", "inspect", "dap", "docs", "new", "import", "export", "doctor", "apply",
                                 "case", "validate"])
        for name in names:
            page = self.run_it(name, "--help")
            self.assertIn("Example:", page.stdout)
            self.assertIn("isogloss " + ("dialect --effective" if name == "dialect" else name), page.stdout)
            self.assertIn("--plugins", page.stdout)
            self.assertEqual(page.stderr, "")

    def test_wrong_usage_is_2_and_talk(self):
        for arguments in ([], ["nonsense"], ["run"], ["run", self.program, "--emit", "plots"],
                          ["run", self.program, "--no-such-option"], ["list", "birds"],
                          ["run", self.program, "--emit", "blocks", "--format", "csv"],
                          ["run", self.program, "--set", "nothing"], ["run", self.program, "--block-skip", "0"],
                          ["explain", "part.nc"], ["case"]):
            done = self.run_it(*arguments, status=2)
            self.assertEqual(done.stdout, "", arguments)
            self.assertNotEqual(done.stderr, "", arguments)

    def test_a_misspelt_command_has_a_hint(self):
        self.assertIn("did you mean 'explain'", self.run_it("explian", status=2).stderr)

    def test_version_names_host_contract_and_plugins(self):
        out = self.run_it("--version").stdout
        for line in ("isogloss ", "contract 1.", "plugin iso ", "plugin fanuc "):
            self.assertIn(line, out)

    def test_places_before_the_command(self):
        empty = self.path / "empty"
        empty.mkdir()
        out = json.loads(self.run_it("--plugins", empty, "doctor", "--json").stdout)
        self.assertEqual(out["PluginFolders"][0], {"Folder": str(empty), "NamedBy": "--plugins", "Exists": True})

    def test_environment_names_places(self):
        out = json.loads(self.run_it("doctor", "--json", env={"ISOGLOSS_PLUGIN_PATH": "/nowhere:/else"}).stdout)
        self.assertEqual([p["Folder"] for p in out["PluginFolders"][:2]], ["/nowhere", "/else"])
        self.assertFalse(out["PluginFolders"][0]["Exists"])


class Run(Command):
    def test_motions_are_json_lines(self):
        done = self.run_it("run", self.program, "-d", "iso")
        events = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([e["Event"] for e in events],
                         ["spindle", "rapid", "feed", "arc", "rapid", "rapid", "feed", "rapid", "end"])
        self.assertEqual(events[1]["Line"], 5)
        self.assertEqual(events[1]["ProgramXyz"], {"X": 10, "Y": 0, "Z": 5})
        self.assertAlmostEqual(events[2]["Feedrate_mmds"], 2)
        self.assertEqual(done.stderr, "")

    def test_the_guessed_dialect_is_said(self):
        done = self.run_it("run", self.program)
        self.assertRegex(done.stderr, r"note: dialect \w+ \(.*\); -d names another \[IG-0514\]")

    def test_relatives_of_fanuc_are_told_apart(self):
        programs = (("%\nO1234 (PART)\nG21 G00 X1.\nM30\n%\n", "fanuc"),
                    ("%\nO12345\nG21 G00 G54.1 P1 X1.\nM30\n%\n", "fanuc"),
                    ("%\n<POCKET>(PROBE)\nG21 G00 X1.\nM30\n%\n", "fanuc"),
                    ("%\nO0012 (FOR THE HAAS)\nG21 G00 X1.\nM30\n%\n", "haas"),
                    ("%\nO01234\nG21 G00 X1.\nM30\n%\n", "haas"),
                    ("%\nO1234\nG21 G00 G154 P2 X1.\nM30\n%\n", "haas"),
                    ("%\nO1234\nG187 P1\nM30\n%\n", "haas"),
                    ("%\nO4113\nG21\nM31\nT1 M6\nM30\n%\n", "fanuc"),
                    ("G54\nT30 M06\nG65 P9995 W54. A20. D-10.\nM30\n", "haas"),
                    ("%\nO1030\nG20\nG00 X1.\nG53 G49 Z0.0 M05 (Z HOME)\nM30\n%\n", "haas"),
                    ("T02 M06\nM59 P2\nG04 P1.0\nM59 P3\nM30\n", "haas"),
                    ("%\nO1030\nG90 G94 G17\nG20\nG53 G0 Z0.\nT1 M6\nG54 G0 X1.\nM30\n%\n", "haas"),
                    ("%\nO1030\nG90 G94 G17 G49 G40 G80\nG20\nG0 X1.\nG53 G0 Z0.\nM30\n%\n", "fanuc"),
                    ("%\nO1030\nG20\nG0 X1.\nG53 G0 Z0.\nM30\n%\n", "fanuc"),
                    ("(BACK)\nG90 G94 G17 G91.1\nG21\nG53 G0 Z0.\nT1 M6\nG0 X1.\nM30\n", "iso"),
                    ("%\nO1030 (VF-2SS, OP 1)\nG20\nG0 X1.\nM30\n%\n", "haas"),
                    ("%\nO1030\n(G54 X0 Y0 is top right corner of part)\nG20\nG0 X1.\nM30\n%\n", "haas"),
                    ("%\nO1030\n(Begin Cutting Blocks)\nG20\nG0 X1.\nM30\n%\n", "haas"),
                    ("%\nO1030\nG20\nG04 P1.\nG53 G00 Z0.\nM30\n%\n", "haas"),
                    ("\ufeff%\nO1234 (MAZAK)\nG54.1 P2 G0 X1.\nM30\n%\n", "mazak"),
                    ("%\nO1234\nG20\n" + "X1.\n" * 900 + "G187 P1\nM30\n%\n", "haas"),
                    ("O1000\nG15 H1\nG0 X1 Y1\nM02\n", "okuma"),
                    ("O1\n(FLANGE)\nG15H=VC32\nM02\n", "okuma"),
                    ("O1\nNCYL G81 X1 Y1 Z-1 R1 F1\nM02\n", "okuma"),
                    ("VC31=VS27\nG0 X1\nM02\n", "okuma"),
                    ("%@MACRO\n#1 := 1;\nM99;\n", "syntec"),
                    ("\n %@macro\nM99;\n", "syntec"),
                    ("%\nO1234 (SYNTEC 22MA)\nG71 G00 X1.\nM30\n%\n", "syntec"),
                    ("%\nG90 G59.4 G00 X1.\nM98 H100\nM30\nN100 M99\n%\n", "syntec"),
                    ("%\n(T4 D=6.)\nN10 G90 G17 G49 G40 G80\nN15 G71\nN20 G00 X1.\nN25 M30\n%\n", "syntec"),
                    ("%\nN10 G00 G17 G71 G40 G49 G80 G90\nN20 X1.\nN30 M30\n%\n", "syntec"),
                    ("%\n//PART\nG70\nG0 X1.\nM30\n%\n", "syntec"),
                    ("G71\nT=\"MILL\" M6\nG0 X1\nM30\n", "siemens"),
                    ("N10 G17 G71 G90\nG0 X0 Y0\nG2 X10 Y0 CR=5 F100\nM30\n", "siemens"),
                    ("(T1 D=10. CR=0.)\nG71\nG2 X10. Y0. R5. F100.\nM30\n", "syntec"),
                    ("O1234\nG81 Z-1. R1. F100. L0\nG70 I10. J0 L4\nG80\nM30\n", "haas"))
        for text, dialect in sampled(programs):
            declined = 1 if "P9995" in text or (dialect == "okuma" and "G15 H1" not in text) else 0
            done = self.run_it("run", self.write("guess.nc", text), "--emit", "none", status=declined)
            self.assertIn(f"note: dialect {dialect} ", done.stderr)

    def test_the_name_of_the_file_tells_the_dialect(self):
        for name, dialect in (("1_HAAS.nc", "haas"), ("OSP5020M.nc", "okuma"), ("fixture_Fanuc.nc", "fanuc")):
            program = self.write(name, "G21 G90\nG0 X1. Y2.\nM30\n")
            done = self.run_it("run", program, "--emit", "none")
            self.assertIn(f"note: dialect {dialect} (from the name of the file", done.stderr)

    def test_the_note_tells_where_the_next_likely_dialect_moves_otherwise(self):
        parting = "; haas, the next candidate, moves differently from line 6 on); -d names another"
        for line, differs in (("G28", True), ("G04 P1000", False)):  # a Haas moves home where a Fanuc moves nothing
            program = self.write("guess.nc", f"%\nO1\nG21 G0 X1.\nG1 X2. F100.\n{line}\nY7.\nM30\n%\n")
            done = self.run_it("run", program, "--emit", "none")
            self.assertIn("note: dialect fanuc (from the text of the program", done.stderr)
            self.assertEqual(parting in done.stderr, differs, done.stderr)
            self.assertNotIn("moves differently", self.run_it("run", program, "-d", "fanuc", "--emit", "none").stderr)

    def test_a_guess_costs_a_long_program_no_more_than_a_moment(self):
        text = "%\nO1\nG21 G0 X1.\nF100.\n" + "".join(f"G1 X{i}. Y{i % 7}.\n" for i in range(200_000)) + "G28\nM30\n%\n"
        done = self.run_it("run", self.write("guess.nc", text), "--emit", "none")
        self.assertNotIn("moves differently", done.stderr)  # beyond what is compared

    def test_part_of_a_klartext_program_is_known_by_its_moves(self):
        for text in ("1 L Z+2,000 R0 F MAX M3\n2 L X+10,000 Y+5,000 R0 F200\n", "L X1 FMAX\nL Z-1 F100\n"):
            done = self.run_it("run", self.write("guess.nc", text), "--emit", "none")
            self.assertIn("note: dialect heidenhain ", done.stderr)

    def test_the_extension_tells_where_the_text_does_not(self):
        for name, dialect in (("guess.mpf", "siemens"), ("guess.nc", "syntec")):
            program = self.write(name, "G71 G90 G17 G40 G49\nG0 X0 Y0 Z5.\nG80\nM30\n")
            done = self.run_it("run", program, "--emit", "none", status=1 if dialect == "siemens" else 0)
            self.assertIn(f"note: dialect {dialect} ", done.stderr)

    def test_the_table_of_the_file_answers_before_the_inherited_one(self):
        dialect = self.write("both.xml", '<Dialect xmlns="urn:isogloss:dialect:1" name="both" extends="fanuc">'
                                         '<Plugins><Plugin name="syntec"/></Plugins><Dependencies>'
                                         '<SyntecParameterTable><Parameter number="4002" Value="3000"/>'
                                         '</SyntecParameterTable></Dependencies></Dialect>')
        program = self.write("pecks.nc", "G00 Z50.\nG99 G73 X0. Z-10. R0. Q5. F100\nG83 X1. Z-10. R0. Q5.\nM30\n")
        for name, back in (("fanuc", -4), (dialect, -2)):
            done = self.run_it("run", program, "-d", name)
            levels = [e["ProgramXyz"]["Z"] for e in map(json.loads, done.stdout.splitlines()) if e["Event"] == "rapid"]
            self.assertEqual(levels.count(back), 2, name)

    def test_hints_name_the_cure(self):
        has_it = 'the plugin fanuc has it: <Plugins> <Plugin name="fanuc"/> </Plugins>'
        no_options = "hint: Configure sets options; "
        for content, cure in (
                ("<Chain><InsertAfter syntax='DwellSyntax'><FanucToolOffsetSyntax/></InsertAfter></Chain>", has_it),
                ("<Dependencies><MacroVariables/></Dependencies>", has_it),
                ("<Dependencies><HaasSettngs/></Dependencies>", "did you mean HaasSettings? The plugin fanuc has it"),
                ("<Dependencies><Remove dependency='ToolOffsetTable'/></Dependencies>",
                 "hint: add <ToolOffsetTable/> to <Dependencies>"),
                ("<Chain><InsertAfter syntax='DwellSyntax'><DwellSyntax/></InsertAfter></Chain>",
                 'hint: give the second one a name of its own: <DwellSyntax as="second"/>'),
                ("<Dependencies><ToolOffsetTable/><ToolOffsetTable/></Dependencies>",
                 'hint: give the second one a name of its own: <ToolOffsetTable as="second"/>'),
                ("<Chain><Configure syntax='DwellSyntax' as='Wait'/></Chain>", no_options + "to give another name"),
                ("<Chain><Configure syntax='DwellSyntax'><DwellSyntax/></Configure></Chain>", no_options),
                ("<Dependencies><Configure dependency='ToolOffsetTable' src='t.xml'/></Dependencies>",
                 no_options + "for a name, a file or rows <Remove> the dependency"),
                ("<Chain>\n<Remove syntax='CoolantSyntax'/>\n<InsertAfter syntax='CoolantSyntax'><DwellSyntax as='x'/>"
                 "</InsertAfter></Chain>", ":2 took it away: name another syntax, or drop that edit"),
                ("<Chain><Configure syntax='DrillingCycleSyntax' clearance='2'/></Chain>", "hint: its options are p-unit"),
                ("<Chain><Configure syntax='PlaneSelectSyntax' clearance='2'/></Chain>", "hint: it has no options"),
                ("<Dependencies><Remove dependency='ToolOffsetTable'/><ToolOffsetTable><Tool id='1' H='2mm'/>"
                 "</ToolOffsetTable></Dependencies>", "hint: it is a number, in mm"),
                ("<Chain><Remove syntax='NoSuchThing'/></Chain>", "hint: isogloss dialect --effective NAME prints"),
                ("<Dependencies><Remove dependency='ToolOffsetTable'/><ToolOffsetTable><Tool id='1' Q='2'/>"
                 "</ToolOffsetTable></Dependencies>", "hint: its columns are H, HWear, D, DWear"),
                ("<Chain>\n<!-- <a> --><Remove syntax='DwellSyntax'></Chain>",
                 "malformed XML: </Chain> stands where <Remove> of line 2 is open"),
                ("<Chain><Remove syntax='PlaneSelectSyntax'/><InsertAfter syntax='LinearMotionSyntax'><PlaneSelectSyntax/>"
                 "</InsertAfter></Chain>", "an order that fits; the same holds of PolarCoordinateSyntax, ScalingSyntax")):
            dialect = self.write("mine.xml", '<Dialect xmlns="urn:isogloss:dialect:1" name="mine" extends="iso">'
                                             f"{content}</Dialect>")
            self.assertIn(cure, self.run_it("lint", dialect, status=1).stderr, content)

    def test_dialect_by_file(self):
        dialect = self.write("mine.xml", '<Dialect xmlns="urn:isogloss:dialect:1" name="mine" extends="iso"/>')
        self.assertEqual(self.run_it("run", self.program, "-d", dialect).stdout,
                         self.run_it("run", self.program, "-d", "iso").stdout)

    def test_formats(self):
        table = self.run_it("run", self.program, "-d", "iso", "--format", "csv").stdout.splitlines()
        self.assertTrue(table[0].startswith("file,line,event,px,py,pz,mx"))
        self.assertEqual(len(table), 10)
        blocks = self.run_it("run", self.program, "-d", "iso", "--emit", "blocks").stdout.splitlines()
        self.assertEqual(json.loads(blocks[2])["Unit"]["System"], "Metric")
        header = self.run_it("run", self.program, "-d", "iso", "--header").stdout.splitlines()[0]
        self.assertEqual(json.loads(header)["Dialect"], "iso")
        self.assertEqual(self.run_it("run", self.program, "-d", "iso", "--emit", "none").stdout, "")
        self.assertIn("rapid", self.run_it("run", self.program, "-d", "iso", "--format", "text").stdout)

    def test_standard_input(self):
        piped = self.run_it("run", "-", "-d", "iso", given=PROGRAM).stdout
        self.assertEqual(len(piped.splitlines()), 9)
        self.assertEqual(json.loads(piped.splitlines()[0])["File"], "-")

    def test_several_programs_are_separate_runs_in_one_table(self):
        other = self.write("other.nc", PROGRAM)
        both = self.run_it("run", self.program, other, "-d", "iso", "--format", "csv").stdout.splitlines()
        self.assertEqual(len(both), 1 + 9 + 9)
        self.assertEqual(both[1].split(",")[2:], both[10].split(",")[2:])

    def test_a_missing_file_is_2_and_the_others_run(self):
        done = self.run_it("run", "missing.nc", self.program, "-d", "iso", status=2)
        self.assertIn("missing.nc: error: cannot be read: No such file or directory [IG-0510]", done.stderr)
        self.assertEqual(len(done.stdout.splitlines()), 9)
        self.assertIn("it is a folder", self.run_it("run", self.path, "-d", "iso", status=2).stderr)

    def test_an_unknown_dialect_is_2(self):
        done = self.run_it("run", self.program, "-d", "izo", status=2)
        self.assertEqual(done.stdout, "")
        self.assertIn("iso", done.stderr)

    def test_errors_in_the_program_are_1(self):
        bad = self.write("bad.nc", "G01 X1. F100.\nG123\n")
        done = self.run_it("run", bad, "-d", "iso", status=1)
        self.assertRegex(done.stderr, r"bad\.nc:2:1: error: .*G123.*\[[A-Z]+-\d+\]")

    def test_own_tables(self):
        offsets = self.write("offsets.xml", '<IsoCoordinateTable xmlns="urn:isogloss:dialect:1">'
                                            '<Offset id="G54" X="100" Y="0" Z="-50"/></IsoCoordinateTable>')

        def first_rapid(*more):
            out = self.run_it("run", self.program, "-d", "iso", *more).stdout.splitlines()
            return json.loads(out[1])["MachineCoordinate"]

        self.assertEqual(first_rapid(), {"X": 10, "Y": 0, "Z": 5})
        self.assertEqual(first_rapid("--offsets", offsets), {"X": 110, "Y": 0, "Z": -45})
        self.assertEqual(first_rapid("--set", "IsoCoordinateTable.G54.Z=-120"), {"X": 10, "Y": 0, "Z": -115})
        self.assertEqual(first_rapid("--offsets", offsets, "--set", "IsoCoordinateTable.G54.Z=1"),
                         {"X": 110, "Y": 0, "Z": 6})
        self.run_it("run", self.program, "-d", "iso", "--set", "IsoCoordinateTable.G54.Z=deep", status=2)
        self.run_it("run", self.program, "-d", "iso", "--set", "NoTable.G54.Z=1", status=2)
        self.run_it("run", self.program, "-d", "iso", "--offsets", "missing.xml", status=2)

    def test_a_machine_brings_what_the_dialect_does_not_have(self):
        def machine(kinematics):
            return self.write("machine.xml", '<Dependencies><MachineAxes><Axis name="X" Home="7" RapidRate="6000"/>'
                                             f"</MachineAxes>{kinematics}</Dependencies>")

        def summary(*more):
            out = self.run_it("run", self.program, "-d", "fanuc", "--summary", *more).stdout
            return dict(line.split(":", 1) for line in out.splitlines())

        # The axes of the machine answer before the parameters that the dialect ships with.
        self.assertIn("unknown", summary("--machine", machine(""))["rapid time"])
        two = ('<MachineKinematics><Axis name="A" Place="table" Order="1"{}/>'
               '<Axis name="C" Place="table" Order="2"/></MachineKinematics>')
        sound = machine(two.format(""))
        for dialect in ("iso", "fanuc"):
            self.run_it("run", self.program, "-d", dialect, "--machine", sound)
            self.run_it("explain", f"{self.program}:5", "-d", dialect, "--machine", sound)
        same = self.run_it("run", self.program, "-d", "iso", "--machine", sound, "--set", "MachineKinematics.A.X=0",
                           "--set", "MachineKinematics.A.Z=1", status=2)
        self.assertIn("axes A, C are parallel", same.stderr)
        self.assertIn("IG-0308", same.stderr)
        # A table that the user's file spoils is said there, not at the dialect that has it.
        spoiled = self.write("machine.xml", '<Dependencies><MachineAxes><Axis name="Q" Home="0"/></MachineAxes>'
                                            "</Dependencies>")
        done = self.run_it("run", self.program, "-d", "iso", "--machine", spoiled, status=2)
        self.assertRegex(done.stderr, r"machine\.xml:1:\d+: error: MachineAxes could not be created.*\[IG-0308\]")
        done = self.run_it("run", self.program, "-d", "iso", "--set", "ToolOffsetTable.1.Radius=5", status=2)
        self.assertRegex(done.stderr, r"'ToolOffsetTable\.1\.Radius' \[IG-0410\]\n.*are H, HWear, D, DWear")
        done = self.run_it("run", self.program, "-d", "fanuc", "--machine", machine(two.format(' Pivot="1"')), status=2)
        self.assertRegex(done.stderr, r"machine\.xml:1:\d+: error: .*Pivot.*\[IG-0219\]")
        done = self.run_it("run", self.program, "-d", "fanuc", "--machine", machine("<MachineKinematic/>"), status=2)
        self.assertRegex(done.stderr, r"machine\.xml:1:\d+: error: .*\[IG-0415\]")
        self.assertIn("did you mean MachineKinematics?", done.stderr)

    def test_shipped_machines(self):
        for name in ("ac-table", "bc-table", "b-head-c-table"):
            done = self.run_it("run", self.program, "-d", "fanuc", "--machine", name, "--summary")
            self.assertNotIn("unknown", done.stdout)
        done = self.run_it("run", self.program, "-d", "fanuc", "--machine", "ac-tabel", status=2)
        self.assertIn("did you mean ac-table?", done.stderr)

    def test_a_dialect_has_its_own_machine(self):
        (self.path / "axes.xml").write_text('<MachineKinematics><Axis name="B" Place="head"/></MachineKinematics>')
        dialect = self.write("mine.xml", '<Dialect xmlns="urn:isogloss:dialect:1" name="mine" extends="fanuc">'
                                         '<Plugins><Plugin name="kinematics"/></Plugins><Dependencies>'
                                         '<MachineKinematics src="axes.xml"/></Dependencies></Dialect>')
        self.run_it("run", self.program, "-d", dialect)
        done = self.run_it("run", self.program, "-d", dialect, "--set", "MachineKinematics.B.Sign=0.5", status=2)
        self.assertIn("axis B: Sign is 1 or -1", done.stderr)

    def test_switches_of_the_machine(self):
        skipping = self.write("skip.nc", "/G00 X1.\nG00 X2.\nM01\nM00\n")

        def events(*more):
            out = self.run_it("run", skipping, "-d", "iso", *more).stdout.splitlines()
            return [json.loads(line)["Event"] for line in out]

        self.assertEqual(events(), ["rapid", "rapid", "stop"])
        self.assertEqual(events("--block-skip", "1"), ["rapid", "stop"])
        self.assertEqual(events("--block-skip", "2,3"), ["rapid", "rapid", "stop"])
        self.assertEqual(events("--optional-stop"), ["rapid", "rapid", "stop", "stop"])

    def test_program_of_a_file(self):
        two = self.write("two.nc", "O0001\nG00 X1.\nM30\nO0002\nG00 X2.\nM30\n")
        out = self.run_it("run", two, "-d", "iso", "--program", "O0002").stdout.splitlines()
        self.assertEqual(json.loads(out[0])["ProgramXyz"]["X"], 2)
        self.assertIn("IG-0406", self.run_it("run", two, "-d", "iso", "--program", "O9", status=1).stderr)

    def test_summary(self):
        done = self.run_it("run", self.program, "-d", "iso", "--summary", "--set", "MachineAxes.X.RapidRate=12000",
                           "--set", "MachineAxes.Y.RapidRate=12000", "--set", "MachineAxes.Z.RapidRate=6000")
        values = dict(line.split(":", 1) for line in done.stdout.splitlines())
        self.assertEqual(values["blocks"].strip(), "10")
        self.assertTrue(values["events"].strip().startswith("9 ("))
        self.assertEqual(values["diagnostics"].strip(), "none")
        self.assertIn("machine Z", values)
        both = self.run_it("run", self.program, "-d", "iso", "--emit", "motions", "--summary")
        self.assertEqual(len(both.stdout.splitlines()), 9)
        self.assertIn("feed length:", both.stderr)

    def test_limits(self):
        limited = self.run_it("run", self.program, "-d", "iso", "--max-blocks", "3", status=1)
        self.assertIn("stopped after 3 blocks", limited.stderr)
        bad = self.write("bad.nc", "G123\n" * 20)
        done = self.run_it("run", bad, "-d", "iso", "--max-errors", "3", status=1)
        self.assertEqual(done.stderr.count("error:"), 3)
        self.assertIn("bad.nc:3: warning: stopped after 3 errors: ", done.stderr)

    def test_messages_stay_short_however_long_the_text(self):
        for text in ["X" * 500_000, "(" + "y" * 500_000]:
            done = self.run_it("run", self.write("long.nc", text + "\n"), "-d", "iso", "--emit", "none", status=1)
            self.assertRegex(done.stderr, r"error: .*\[ISO-")
            self.assertLess(len(done.stderr), 4000)

    def test_checked_and_call_all_change_nothing(self):
        plain = self.run_it("run", self.program, "-d", "fanuc").stdout
        self.assertEqual(self.run_it("run", self.program, "-d", "fanuc", "--checked").stdout, plain)
        self.assertEqual(self.run_it("run", self.program, "-d", "fanuc", "--checked", "--call-all").stdout, plain)


class Diagnostics(Command):
    def setUp(self):
        super().setUp()
        self.bad = self.write("bad.nc", "G123\n" * 20 + "G21 G0 X1.\n" * 10)

    def test_repeats_are_grouped(self):
        done = self.run_it("run", self.bad, "-d", "iso", status=1)
        self.assertEqual(done.stderr.count("error:"), 5)
        self.assertRegex(done.stderr, r"… and 15 more \[[A-Z]+-\d+\]")
        self.assertEqual(self.run_it("run", self.bad, "-d", "iso", "--repeats", "0", status=1).stderr.count("error:"), 20)

    def test_what_is_no_program_is_doubted(self):
        text = self.write("notes.txt", "Ask the shop for\nthe offsets and the\ntools of this part,\nthen write it\nanew.\n")
        self.assertIn("IG-0518", self.run_it("run", text, "-d", "fanuc", status=1).stderr)
        self.assertNotIn("IG-0518", self.run_it("run", self.bad, "-d", "iso", status=1).stderr)

    def test_empty_files_and_wide_text_are_said(self):
        for text in ("", "\n \r\n"):
            self.assertIn("IG-0423", self.run_it("run", self.write("empty.nc", text), "-d", "fanuc").stderr)
        wide = self.write("wide.nc", "")
        with open(wide, "wb") as file:
            file.write("G0 X1.\n".encode("utf-16"))
        done = self.run_it("run", wide, "-d", "fanuc", status=1)
        self.assertIn("IG-0413", done.stderr)
        self.assertEqual(done.stderr.count("[IG-"), 1)

    def test_json(self):
        done = self.run_it("run", self.bad, "-d", "iso", "--diagnostics", "json", status=1)
        lines = [json.loads(line) for line in done.stderr.splitlines()]
        self.assertEqual(len(lines), 20)
        self.assertEqual((lines[3]["Severity"], lines[3]["Line"], lines[3]["Column"], lines[3]["EndColumn"]),
                         ("error", 4, 1, 5))

    def test_sarif(self):
        done = self.run_it("run", self.bad, "-d", "iso", "--diagnostics=sarif", status=1)
        run = json.loads(done.stderr)["runs"][0]
        self.assertEqual(len(run["results"]), 20)
        self.assertEqual(run["results"][0]["locations"][0]["physicalLocation"]["region"],
                         {"startLine": 1, "startColumn": 1, "endColumn": 5})
        self.assertEqual(run["tool"]["driver"]["name"], "isogloss")
        clean = self.run_it("run", self.program, "-d", "iso", "--diagnostics=sarif")
        self.assertEqual(json.loads(clean.stderr)["runs"][0]["results"], [])

    def test_warnings_as_errors(self):
        odd = self.write("odd.nc", "M77\n")
        self.assertIn("warning:", self.run_it("run", odd, "-d", "iso").stderr)
        self.assertIn("error:", self.run_it("run", odd, "-d", "iso", "--werror", status=1).stderr)

    def test_no_colours_in_a_pipe_and_no_control_bytes(self):
        self.write("esc.nc", "G00 X1. \x1b[31m\n")
        done = subprocess.run([OPTIONS.isogloss, "run", "esc.nc", "-d", "iso"], cwd=self.path, capture_output=True,
                              check=False)
        self.assertNotIn(b"\x1b", done.stderr)
        self.assertNotEqual(done.stderr, b"")


class Output(Command):
    def test_a_file_appears_complete(self):
        out = self.path / "out.jsonl"
        done = self.run_it("run", self.program, "-d", "iso", "-o", out)
        self.assertEqual(done.stdout, "")
        self.assertEqual(len(out.read_text().splitlines()), 9)
        self.assertEqual(sorted(p.name for p in self.path.iterdir()), ["out.jsonl", "part.nc"])

    def test_a_failed_start_leaves_the_old_file(self):
        out = self.write("out.jsonl", "old")
        self.run_it("run", self.program, "-d", "nothing", "-o", out, status=2)
        self.assertEqual(out.read_text(), "old")
        self.assertEqual(sorted(p.name for p in self.path.iterdir()), ["out.jsonl", "part.nc"])

    def test_links_and_modes_stay(self):
        target = self.write("target", "old")
        target.chmod(0o640)
        link = self.path / "link"
        link.symlink_to(target)
        self.run_it("run", self.program, "-d", "iso", "-o", link)
        self.assertTrue(link.is_symlink())
        self.assertEqual(len(target.read_text().splitlines()), 9)
        self.assertEqual(target.stat().st_mode & 0o777, 0o640)

    def test_devices_and_pipes_are_written_to(self):
        self.run_it("run", self.program, "-d", "iso", "-o", "/dev/null")
        self.assertTrue(pathlib.Path("/dev/null").is_char_device())
        pipe = self.path / "pipe"
        os.mkfifo(pipe)
        with subprocess.Popen(["cat", pipe], stdout=subprocess.PIPE, text=True) as reader:
            self.run_it("run", self.program, "-d", "iso", "-o", pipe)
            self.assertEqual(len(reader.communicate(timeout=20)[0].splitlines()), 9)

    def test_refused_targets_are_2(self):
        self.assertIn("IG-0511", self.run_it("run", self.program, "-d", "iso", "-o", self.path, status=2).stderr)
        self.assertIn("IG-0511", self.run_it("run", self.program, "-d", "iso", "-o", "no/such/folder/x",
                                             status=2).stderr)

    def test_a_full_disk_is_2(self):
        with open("/dev/full", "w", encoding="ascii") as full:
            done = subprocess.run([OPTIONS.isogloss, "run", self.program, "-d", "iso"], stdout=full,
                                  stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("No space left", done.stderr)

    def test_a_closed_reader_ends_quietly(self):
        long = self.write("long.nc", "".join(f"G21 G01 X{i % 90}. Y{i % 70}. F1000.\n" for i in range(100_000)))
        for arguments in (["run", long, "-d", "iso"], ["list", "fields", "--json"]):
            with subprocess.Popen([OPTIONS.isogloss, *map(str, arguments)], stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE) as process:
                process.stdout.read(10)
                process.stdout.close()
                said = process.stderr.read()
                self.assertEqual(process.wait(timeout=60), 0, arguments)
                self.assertEqual(said, b"")


class Listing(Command):
    def test_every_list(self):
        for what, key, sample in (("plugins", "Name", "iso"), ("dialects", "Name", "fanuc"),
                                  ("syntaxes", "Id", "DrillingCycleSyntax"), ("dependencies", "Id", "IsoCoordinateTable"),
                                  ("fields", "Path", "ProgramXyz.X"), ("diagnostics", "Code", "IG-0206")):
            rows = json.loads(self.run_it("list", what, "--json").stdout)
            self.assertIn(sample, [row[key] for row in rows])
            text = self.run_it("list", what).stdout
            self.assertEqual(len(text.splitlines()), len(rows))
            self.assertIn(sample, text)
        self.assertIn("plugins", self.run_it("list").stdout)

    def test_codes_of_a_dialect(self):
        rows = json.loads(self.run_it("list", "codes", "-d", "fanuc", "--json").stdout)
        g81 = [row for row in rows if row["Code"] == "G81"]
        self.assertIn(("code", "DrillingCycleSyntax", "iso/cycles/drilling_cycle_syntax.md"),
                      [(row["Kind"], row["Syntax"], row["Page"]) for row in g81])
        self.assertIn("R", g81[0]["Words"])
        codes = [row["Code"] for row in rows]
        self.assertLess(codes.index("G02"), codes.index("G10"))
        text = self.run_it("list", "codes", "-d", "fanuc").stdout
        self.assertEqual(len(text.splitlines()), len(rows))
        self.assertRegex(text, r"(?m)^G68\.2 +code +IsoG68p2TiltSyntax +iso/five_axis/iso_g68p2_tilt_syntax\.md$")
        for row in rows:
            self.assertTrue((pathlib.Path(__file__).parents[2] / "plugins" / row["Page"]).is_file(), row)
        text = self.run_it("list", "codes", "-d", "siemens").stdout
        self.assertRegex(text, r"(?m)^CYCLE83 +code +SiemensDeepHoleCycleSyntax +"
                               r"siemens/cycles/siemens_deep_hole_cycle_syntax\.md$")
        self.assertIn("needs a dialect", self.run_it("list", "codes", status=2).stderr)
        self.assertIn("accept none", self.run_it("list", "fields", "-d", "iso", status=2).stderr)

    def test_diagnostics_are_complete_and_unique(self):
        rows = json.loads(self.run_it("list", "diagnostics", "--json").stdout)
        codes = [row["Code"] for row in rows]
        self.assertEqual(len(codes), len(set(codes)))
        for row in rows:
            self.assertTrue(row["Text"] and row["Explanation"] and row["Severity"], row)
        for code in (codes[0], codes[-1]):
            self.assertIn(code, self.run_it("explain", code).stdout)

    def test_inspect(self):
        page = self.run_it("inspect", "DrillingCycleSyntax").stdout
        self.assertTrue(page.startswith("# DrillingCycleSyntax"))
        self.assertIn("p-unit", page)
        described = json.loads(self.run_it("inspect", "DrillingCycleSyntax", "-d", "fanuc", "--json").stdout)
        self.assertEqual(described["In fanuc"][0]["Options"]["p-unit"], "ms")
        self.assertIn("IncrementalResolveSyntax", described["Before"])
        table = json.loads(self.run_it("inspect", "IsoCoordinateTable", "--json").stdout)
        self.assertIn("isogloss.work-offset/1", table["Provides"])
        field = json.loads(self.run_it("inspect", "ProgramXyz.X", "--json").stdout)
        self.assertIn("ProgramXyzSyntax", field["Writers"])
        dialect = json.loads(self.run_it("inspect", "fanuc", "--json").stdout)
        self.assertIn("iso", dialect["Extends"])
        done = self.run_it("inspect", "DrilingCycleSyntax", status=2)
        self.assertRegex(done.stderr, r"\[IG-0516\]\n  hint: did you mean DrillingCycleSyntax\?")

    def test_doctor_explains_what_is_not_loaded(self):
        self.write("notes.so", "no library")
        done = self.run_it("doctor", "--plugins", self.path, status=1)
        self.assertIn("notes.so", done.stdout)
        self.assertIn("[IG-0301]", done.stdout)
        self.assertIn("All is well.", self.run_it("doctor").stdout)

    def test_schemas(self):
        self.assertIn("urn:isogloss:dialect:1", self.run_it("schema", "dialect").stdout)
        self.assertIn("ProgramXyz", json.loads(self.run_it("schema", "block").stdout)["properties"])


class Dialects(Command):
    def dialect(self, chain):
        return self.write("mine.xml", '<Dialect xmlns="urn:isogloss:dialect:1" name="mine" extends="iso">'
                                      f"<Chain>{chain}</Chain></Dialect>")

    def test_lint(self):
        self.assertRegex(self.run_it("lint", "iso", "fanuc").stdout, r"iso: \d+ syntaxes.*\nfanuc: \d+ syntaxes")
        done = self.run_it("lint", self.dialect('<Configure syntax="DwellSyntax" p-unit="hours"/>'), status=1)
        self.assertRegex(done.stderr, r"mine\.xml:1:\d+: error: .*p-unit.*\[IG-0205\]")
        self.assertEqual(self.run_it("lint", "nothing", status=1).stdout, "")
        self.assertEqual(self.run_it("lint", "iso", "fanuc").stderr, "")

    def test_a_code_of_an_option_is_a_path(self):
        dialect = self.write("mine.xml", '<Dialect xmlns="urn:isogloss:dialect:1" name="mine" extends="fanuc"><Chain>'
                             '<Configure syntax="InertCodeSyntax" codes="Parsing.Flags.M200 M201"/></Chain></Dialect>')
        done = self.run_it("lint", dialect, status=1)
        self.assertIn("'M201' is not the path of a code: write Parsing.Flags.M201 [IG-0243]", done.stderr)

    def test_a_command_without_dialects_says_so(self):
        alone = shutil.copy(OPTIONS.isogloss, self.path / "isogloss")
        environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")}
        done = subprocess.run([alone, "run", self.program], capture_output=True, text=True, check=False, timeout=60,
                              env=environment)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("[IG-0512]", done.stderr)

    def without_proc(self, *words):
        """The command in a namespace in which /proc is empty; None where this system gives none."""
        if shutil.which("unshare") is None:
            return None
        hide = ["unshare", "-rm", "sh", "-c", 'mount -t tmpfs none /proc && exec "$@"', "sh"]
        if subprocess.run([*hide, "true"], capture_output=True, check=False).returncode != 0:
            return None
        environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")}
        return subprocess.run([*hide, *map(str, words)], capture_output=True, text=True, check=False, timeout=60,
                              env=environment)

    def test_without_proc_the_command_finds_its_plugins_by_its_name(self):
        done = self.without_proc(OPTIONS.isogloss, "list", "dialects")
        if done is None:
            self.skipTest("no user namespaces")
        self.assertIn("fanuc", done.stdout)
        if "LeakSanitizer has encountered a fatal error" in done.stderr:
            self.skipTest("a sanitizer looks for leaks, and reads its options, by way of /proc")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("IG-0610", done.stderr)

    def test_a_command_that_does_not_know_its_folder_says_so(self):
        program = ("import os, sys\nf = os.open(sys.argv[1], os.O_RDONLY)\nos.set_inheritable(f, True)\n"
                   "os.execve(f, ['isogloss', 'list', 'dialects'], os.environ)\n")
        done = self.without_proc(sys.executable, "-c", program, OPTIONS.isogloss)
        if done is None:
            self.skipTest("no user namespaces")
        self.assertIn("[IG-0610]", done.stderr)

    def test_lint_starts_the_chain(self):
        """Values that a dependency rejects are reported before the first run."""
        dialect = self.path / "machine.xml"
        dialect.write_text('<Dialect xmlns="urn:isogloss:dialect:1" name="machine" extends="iso"><Dependencies>'
                           '<MachineAxes><Axis name="Q" Home="0"/></MachineAxes></Dependencies></Dialect>')
        done = self.run_it("lint", dialect, status=1)
        self.assertRegex(done.stderr, r"machine\.xml:1:\d+: error: MachineAxes could not be created: axis 'Q'.*IG-0308")
        self.assertEqual(done.stdout, "")

    def test_suggest(self):
        wrong = self.dialect('<Remove syntax="McXyzSyntax"/>'
                             '<InsertBefore syntax="ProgramXyzSyntax"><McXyzSyntax/></InsertBefore>')
        done = self.run_it("lint", wrong, "--suggest", status=1)
        self.assertIn("IG-020", done.stderr)
        self.assertRegex(done.stdout, r"(?m)^\+.*<Insert(After|Before) syntax=.*<McXyzSyntax/>")
        self.assertIn("the order is right", self.run_it("lint", "iso", "--suggest").stdout)

    def test_a_syntax_in_a_wrong_place_is_explained(self):
        wrong = self.dialect('<Remove syntax="McXyzSyntax"/>'
                             '<InsertBefore syntax="ProgramXyzSyntax"><McXyzSyntax/></InsertBefore>')
        done = self.run_it("dialect", wrong, "--why", "McXyzSyntax", status=1)
        self.assertIn("[IG-020", done.stderr)
        self.assertIn("McXyzSyntax of plugin iso, stage Logic", done.stdout)

    def test_faults_of_parts_and_of_the_order_are_told_at_once(self):
        wrong = self.dialect('<Configure syntax="DwellSyntax" unit="s"/><Remove syntax="McXyzSyntax"/>'
                             '<InsertBefore syntax="ProgramXyzSyntax"><McXyzSyntax/></InsertBefore>')
        done = self.run_it("lint", wrong, status=1)
        self.assertIn("[IG-0204]", done.stderr)
        self.assertRegex(done.stderr, r"\[IG-020[67]\]")

    def test_a_plugin_that_is_missing_is_told_with_the_folders(self):
        wrong = self.write("x.xml", '<Dialect xmlns="urn:isogloss:dialect:1" name="x" extends="iso">'
                           '<Plugins><Plugin name="nothing-such"/></Plugins></Dialect>')
        done = self.run_it("lint", wrong, "--plugins", self.path, status=1)
        self.assertRegex(done.stderr, rf"\[IG-0201\]\n  hint: searched: {self.path}, ")

    def test_effective_loads_back(self):
        effective = self.path / "effective.xml"
        self.run_it("dialect", "--effective", "fanuc", "-o", effective)
        again = self.run_it("dialect", "--effective", effective).stdout
        self.assertEqual(again, effective.read_text())
        self.assertEqual(self.run_it("run", self.program, "-d", effective).stdout,
                         self.run_it("run", self.program, "-d", "fanuc").stdout)
        self.run_it("dialect", "--effective", "nothing", status=1)


class Subprograms(Command):
    def xs(self, done):
        return [line.split(",")[3] for line in done.stdout.splitlines()[1:] if ",end," not in line]

    def run_csv(self, *arguments, status=0, **more):
        return self.run_it("run", *arguments, "-d", "fanuc", "--format", "csv", status=status, **more)

    def test_programs_lie_beside_the_program_or_where_the_user_says(self):
        main = self.write("main.nc", "G91 G00 X1.\nM98 P77\nX1.\nM30\n")
        done = self.run_csv(main, status=1)
        self.assertRegex(done.stderr, r"main\.nc:2:5: error: program O77 is not found.*folder .* \[ISO-0485\]")
        (self.path / "more").mkdir()
        self.write("more/o0077.TAP", "%\nO0077\nX10.\nM99\n%\n")
        self.assertEqual(self.xs(self.run_csv(main, "--subprograms", "more")), ["1", "11", "12"])
        self.write("O77", "X20.\nM99\n")
        done = self.run_csv(main, "--subprograms", "more")
        self.assertEqual(self.xs(done), ["1", "21", "22"])
        self.assertIn("O77,1,rapid", done.stdout)
        self.run_csv(main, "--subprograms", "nowhere", status=2)

    def test_standard_input_goes_back(self):
        program = "O1\nG91 G00\nM98 P2 L3\nM30\nO2\nX1.\nM99\n"
        self.assertEqual(self.xs(self.run_csv("-", given=program)), ["1", "2", "3"])
        long_program = program.replace("O2\n", ("(" + "x" * 60 + ")\n") * 40000 + "O2\n")
        self.assertEqual(self.xs(self.run_csv("-", given=long_program)), ["1", "2", "3"])
        done = self.run_csv("-", given=long_program, status=1, env={"TMPDIR": str(self.path / "nowhere")})
        self.assertIn("IG-0421", done.stderr)

    def test_links_and_folders_are_no_programs(self):
        outside = tempfile.NamedTemporaryFile("w", suffix=".nc", delete=False)
        self.addCleanup(os.unlink, outside.name)
        outside.write("X99.\nM99\n")
        outside.close()
        (self.path / "O5").mkdir()
        (self.path / "O6.nc").symlink_to(outside.name)
        os.mkfifo(self.path / "O7.nc")
        main = self.write("main.nc", "G91 G00\nM98 P5\nM98 P6\nM98 P7\nM98 P8\nM30\n")
        done = self.run_csv(main, status=1)
        for said in ("O5 is a folder", "O6.nc is a link that leads out", "O7.nc is not a regular file", "program O8"):
            self.assertIn(said, done.stderr)
        self.assertEqual(self.xs(done), [])

    def test_endless_programs_end_soon(self):
        for name, program, code in sampled((
                ("restart", "O1\nG91 X1.\nM99\n", "IG-0417"),
                ("return", "O1\nN1 M98 P2\nO2\nM99 P1\n", "IG-0417"),
                ("itself", "O1\nM98 P1\nM99\n", "ISO-0486"),
                ("often", "O1\nM98 P2 L9999\nM30\nO2\nM98 P3 L9999\nM99\nO3\nM99\n", "IG-0417"))):
            with self.subTest(name):
                begin = os.times().children_user  # a busy machine is not the program's fault
                done = self.run_csv(self.write("endless.nc", program), "--emit", "none", "--main-passes", "0", status=1)
                self.assertIn(code, done.stderr)
                self.assertLess(os.times().children_user - begin, OPTIONS.seconds)

    def test_long_lines_of_brackets_and_comments_are_read_once(self):
        for line in sampled(("X[1+1]" * 150000, "X[1(a)+1]" * 100000, "#1=" + "(a)1+(b)" * 100000 + "1",
                             "(a)" * 300000 + "X1.", "X1.;" * 100000)):
            main = self.write("main.nc", f"O1\n{line}\nM30\n")
            begin = os.times().children_user
            self.run_it("run", main, "-d", "fanuc", "--emit", "none", status=0)
            self.assertLess(os.times().children_user - begin, OPTIONS.seconds, line[:10])

    def test_tables_take_no_sum_that_no_number_holds(self):
        big = "17" + 307 * "0" + "."
        main = self.write("main.nc", f"O1\nG91\nG10 L2 P2 X{big}\nG10 L2 P2 X{big}\n#2001={big}\n#2201={big}\nG43 H1 Z1.\nM30\n")
        done = self.run_it("run", main, "-d", "fanuc", "--emit", "blocks", status=1)
        for line in done.stdout.splitlines():
            json.loads(line)
        for code in ("ISO-0222", "ISO-0223"):
            self.assertIn(code, done.stderr)
        main = self.write("main.nc", f"O1\nG91\n#12001={big}\n#13001={big}\nG41 D1 X1.\nX2.\nM30\n")
        self.assertIn("ISO-0477", self.run_it("run", main, "-d", "fanuc", "--emit", "blocks", status=1).stderr)

    def test_the_block_of_a_modal_call_calls_or_waits(self):
        self.write("waits.xml", '<Dialect xmlns="urn:isogloss:dialect:1" name="waits" title="A mill" extends="fanuc">'
                   '<Chain><Configure syntax="FanucMacroCallSyntax" each-block-call="waits"/></Chain></Dialect>')
        main = self.write("main.nc", "O1\nG66.1 P9100 X1.\nX2.\nG67\nM30\nO9100\nX[10*#24]\nM99\n")
        self.assertEqual(self.xs(self.run_csv(main, status=0)), ["10", "20"])
        done = self.run_it("run", main, "-d", self.path / "waits.xml", "--format", "csv", status=0)
        self.assertEqual(self.xs(done), ["20"])

    def test_machines_differ_in_what_p_and_m97_mean(self):
        self.write("haas_like.xml", '<Dialect xmlns="urn:isogloss:dialect:1" name="haas_like" title="A mill" '
                   'extends="fanuc"><Chain><Configure syntax="SubprogramCallSyntax" p-form="whole" m97="yes" m198="no" '
                   'start-address="H" levels="1"/></Chain></Dialect>')
        main = self.write("main.nc", "O1\nG91 G00\nM98 P51234\nM97 P500 L2\nM98 P3 H20\nM198 P3\nM97 P600\nM30\n"
                          "N500 X100.\nM99\nN600 M98 P3\nM99\nO51234\nX1.\nM99\nO3\nX5.\nN20 X10.\nM99\n")
        done = self.run_it("run", main, "-d", self.path / "haas_like.xml", "--format", "csv", status=1)
        self.assertEqual(self.xs(done), ["1", "101", "201", "211"])
        self.assertIn("main.nc:6:1: error: M198 is not executed", done.stderr)
        self.assertIn("main.nc:11:10: error: calls are already nested 1 deep", done.stderr)
        self.assertNotIn("IG-0414", done.stderr)
        done = self.run_csv(main, status=1)
        self.assertIn("main.nc:3:5: warning: M98: there is no O1234 for P51234", done.stderr)
        self.assertIn("main.nc:4:1: error: M97 is not executed", done.stderr)

    def test_limits_are_options(self):
        program = self.write("deep.nc", "O1\nM98 P2\nM30\nO2\nM98 P3\nM99\nO3\nM99\n")
        self.run_csv(program)
        self.assertIn("IG-0416", self.run_csv(program, "--max-depth", "1", status=1).stderr)
        self.assertIn("IG-0417", self.run_csv(program, "--max-jumps", "2", status=1).stderr)
        program = self.write("often.nc", "O1\nF100\nM98 P2 L9999\nM30\nO2\nG01 X1.\nM98 P3\nM99\nO3\nG91 X1.\nM99\n")
        done = self.run_csv(program, "--max-repeat-blocks", "100", status=1)
        self.assertIn("error: stopped after 100 blocks of repeated calls, in pass 16 of 9999 of O2 called at ",
                      done.stderr)
        self.assertIn("often.nc:3: --max-repeat-blocks sets another limit [IG-0450]", done.stderr)
        self.assertEqual(len(self.xs(done)), 31)
        program = self.write("loop.nc", "O1\n#1=0\nWHILE[#1LT300000]DO1\n#1=#1+1\n#2=#1\n#2=#1\nEND1\nM30\n")
        self.assertNotIn("IG-04", self.run_csv(program, "--emit", "none").stderr)  # 1,500,000 blocks


class Explain(Command):
    def test_a_line(self):
        out = self.run_it("explain", f"{self.program}:7", "-d", "iso", "--all").stdout
        self.assertIn("part.nc:7: G02 X0. Y-10. R10. (QUARTER)", out)
        self.assertIn("CircularMotionSyntax (iso)", out)
        self.assertIn("+ MotionEvent.IsCcw = false", out)
        self.assertRegex(out, r"Feedrate\.FeedrateValue = 120 +FeedrateSyntax, line 6")
        self.assertIn("Slept", out)

    def test_json(self):
        block = json.loads(self.run_it("explain", f"{self.program}:6", "-d", "iso", "--json").stdout)[0]
        self.assertEqual((block["Line"], block["Text"]), (6, "G01 Z-1. F120."))
        steps = {step["Syntax"]: step["Changes"] for step in block["Steps"]}
        self.assertIn({"Path": "Feedrate.FeedrateValue", "After": 120}, steps["FeedrateSyntax"])
        self.assertEqual(block["Document"]["ProgramXyz"], {"X": 10, "Y": 0, "Z": -1})
        carried = {value["Path"]: value for value in block["Carried"]}
        self.assertEqual(carried["ProgramXyz.Z"]["Line"], 5)
        self.assertIn("CircularMotionSyntax", [s["Syntax"] for s in block["Slept"]])

    def test_a_code(self):
        out = self.run_it("explain", "IG-0206").stdout
        self.assertIn("must stand after", out)
        self.assertIn("lint --suggest", out)
        self.run_it("explain", "IG-9999", status=2)
        self.assertIn("  stopped after … errors: --max-errors sets another limit\n", self.run_it("explain", "IG-0517").stdout)

    def test_calls_are_followed(self):
        self.write("O20", "O20\nG91 X1.\nM98 P30 L2\nM99\n")
        self.write("O30.NC", "O30\nY2.\nM99\n")
        main = self.write("calls.nc", "G00 X0 Y0\nM98 P20\nM98 P20\nM30\n")
        out = self.run_it("explain", f"{main}:2", "--in", "O30.NC", "--pass", "4", "-d", "fanuc").stdout
        self.assertIn("O30.NC:2: Y2.\n", out)
        self.assertIn("called O20 by", out)
        self.assertRegex(out, r"called O30 by .*O20:3, pass 2 of 2")
        self.assertIn("pass 4 over this line", out)
        block = json.loads(self.run_it("explain", f"{main}:2", "--in", "O20", "-d", "fanuc", "--json").stdout)[0]
        self.assertEqual((block["Line"], block["Pass"]), (2, 1))
        self.assertEqual([(f.get("Program"), f.get("CallLine")) for f in block["Frames"]], [(None, None), ("O20", 2)])
        done = self.run_it("explain", f"{main}:2", "--in", "O20", "--pass", "3", "-d", "fanuc", status=1)
        self.assertIn("the run comes to this line 2 times", done.stderr)

    def test_a_line_of_a_plain_program_ends_the_run(self):
        out = self.run_it("explain", f"{self.program}:7", "-d", "iso")
        self.assertNotIn("pass", out.stdout)

    def test_no_block(self):
        done = self.run_it("explain", f"{self.program}:99", "-d", "iso", status=1)
        self.assertIn("the run has no block at line 99 [IG-0515]", done.stderr)

    def test_a_line_that_is_not_reached_says_why(self):
        self.write("O20", "O20\nG91 X1.\nM99\nX2.\n")
        text = "G21\nG00 X0 Y0\n\nGOTO 9\nX1.\nN9 X2.\nM98 P20\nM30\nX3.\n"
        for ending in ("\r", "\r\n"):
            main = self.write("endings.nc", text.replace("\n", ending))
            for line, reason in ((3, "the line is empty"), (10, "the file has 9 lines")):
                done = self.run_it("explain", f"{main}:{line}", "-d", "fanuc", status=1)
                self.assertIn(f"hint: {reason}\n", done.stderr)
        main = self.write("jumps.nc", text)
        for line, reason in ((3, "the line is empty"), (5, "the run goes from line 4 to line 6"),
                             (9, "the run ends at .*jumps.nc:8: M30"), (10, "the file has 9 lines")):
            done = self.run_it("explain", f"{main}:{line}", "-d", "fanuc", status=1)
            self.assertRegex(done.stderr, rf"jumps.nc:{line}: error: the run has no block at line {line}.*\n  hint: {reason}")
        done = self.run_it("explain", f"{main}:4", "--in", "O20", "-d", "fanuc", status=1)
        self.assertRegex(done.stderr, r"hint: the run ends at .*jumps.nc:8: M30")
        done = self.run_it("explain", f"{main}:4", "--in", "O21", "-d", "fanuc", status=1)
        self.assertIn("hint: no block of this file is executed", done.stderr)
        stops = self.write("stops.nc", "G21 X1.\nM99 P7\nX3.\n")
        done = self.run_it("explain", f"{stops}:3", "-d", "fanuc", status=1)
        self.assertIn("[ISO-0494]", done.stderr)
        self.assertRegex(done.stderr, r"hint: the run ends at .*stops.nc:2: M99 P7")

    def test_who_answers_a_syntax(self):
        part = self.write("offsets.nc", "G21 G90\nG55 G0 X1.\n")
        out = self.run_it("explain", f"{part}:2", "-d", "fanuc").stdout
        self.assertRegex(out, r"\(IsoCoordinateOffsetSyntax, iso\), asks IsoCoordinateTable")
        steps = json.loads(self.run_it("explain", f"{part}:2", "-d", "fanuc", "--json").stdout)[0]["Steps"]
        asks = {s["Syntax"]: s.get("Asks", []) for s in steps}["IsoCoordinateOffsetSyntax"]
        self.assertIn({"Service": "isogloss.work-offset/1", "Dependency": "IsoCoordinateTable"}, asks)
        self.run_it("explain", "missing.nc:1", status=2)


class Cases(Command):
    CASE = """# DwellSyntax

## P in seconds

#BeforeBuild:
```json
{"Parsing": {"G04": {"P": 0.5}}, "Other": {"Kept": 1}}
```
#AfterBuild:
```json
{"Other": {"Kept": 1.0}, "Dwell": {"Time": %s}}
```
"""

    def test_apply(self):
        done = self.run_it("apply", "DwellSyntax", given='{"Parsing": {"G04": {"P": 0.5}, "F": 100.0}}')
        self.assertEqual(json.loads(done.stdout), {"Parsing": {"F": 100}, "Dwell": {"Time": 0.5}})
        self.assertTrue(done.stdout.startswith('{\n  "'))
        given = '{"Parsing": {"G04": {"P": 500}}}'
        self.assertEqual(json.loads(self.run_it("apply", "DwellSyntax", "-d", "fanuc", given=given).stdout),
                         {"Dwell": {"Time": 0.5}})

    def test_apply_with_a_previous_block(self):
        before = self.write("previous.json", '{"ProgramXyz": {"X": 1, "Y": 2, "Z": 3}}')
        done = self.run_it("apply", "ProgramXyzSyntax", "--previous", before, given='{"Parsing": {"Y": 7.5}}')
        self.assertEqual(json.loads(done.stdout), {"ProgramXyz": {"X": 1, "Y": 7.5, "Z": 3}})
        done = self.run_it("apply", "ProgramXyzSyntax", given='{"Parsing": {"Y": 7.5}}')
        self.assertEqual(json.loads(done.stdout), {"ProgramXyz": {"X": 0, "Y": 7.5, "Z": 0}})

    def test_apply_a_scanner(self):
        done = self.run_it("apply", "IsoCommentSyntax", given='{"UnparsedText": "N10 G1 X5 (hole)"}')
        self.assertEqual(json.loads(done.stdout),
                         {"UnparsedText": "N10 G1 X5", "Comment": {"Symbol": "(", "Text": "hole"}})

    def test_apply_refuses(self):
        self.assertIn("did you mean DwellSyntax", self.run_it("apply", "DwelSyntax", given="{}", status=2).stderr)
        self.assertIn("IG-0502", self.run_it("apply", "DwellSyntax", given="{", status=1).stderr)
        self.assertIn("IG-0502", self.run_it("apply", "DwellSyntax", given="[]", status=1).stderr)
        wrong = '{"Feedrate": {"FeedrateValue": "fast"}}'
        self.assertIn("Feedrate.FeedrateValue", self.run_it("apply", "DwellSyntax", given=wrong, status=1).stderr)

    def test_cases_hold_or_show_the_difference(self):
        self.assertIn("1 cases of 1 pages: 1 hold, 0 fail",
                      self.run_it("case", self.write("a.md", self.CASE % "0.5")).stdout)
        done = self.run_it("case", self.write("b.md", self.CASE % "5"), status=1)
        self.assertIn("Dwell.Time: expected 5, got 0.5", done.stdout)
        self.assertRegex(done.stderr, r"b\.md:5: error: case 'P in seconds' of DwellSyntax does not hold \[IG-0505\]")
        self.assertNotIn("the document after the build", done.stdout)
        done = self.run_it("case", self.path / "b.md", "--verbose", status=1)
        self.assertIn('the document after the build:\n{\n  "Dwell"', done.stdout)

    def test_a_fault_of_a_case_has_its_place_in_the_page(self):
        page = self.write("c.md", self.CASE.replace('{"Parsing"', '{\n  "Parsing":: 1, "Parsing"') % "0.5")
        text = page.read_text().splitlines()
        line = next(i for i, one in enumerate(text, 1) if "::" in one)
        self.assertRegex(self.run_it("case", page, status=1).stdout,
                         rf"c\.md:{line}:{text[line - 1].index('::') + 2}: error: .*\[IG-0502\]")

    def test_options_dependencies_and_diagnostics_of_a_case(self):
        text = """# DwellSyntax
## milliseconds
#Dependencies:
```xml
<DwellSyntax p-unit="ms"/>
```
#BeforeBuild:
```json
{"Parsing": {"G04": {"P": 500}}}
```
#AfterBuild:
```json
{"Dwell": {"Time": 0.5}}
```
#Diagnostics:
```
```
"""
        self.run_it("case", self.write("a.md", text))
        wanted = text.replace("#Diagnostics:\n```\n", "#Diagnostics:\n```\nISO-0215\n")
        self.assertIn("diagnostics: expected ISO-0215, got", self.run_it("case", self.write("b.md", wanted),
                                                                         status=1).stdout)

    def test_a_malformed_page_is_an_error(self):
        page = self.write("c.md", "# DwellSyntax\n## open\n#BeforeBuild:\n```json\n{}\n```\n")
        self.assertIn("[IG-0501]", self.run_it("case", page, status=1).stderr)
        self.run_it("case", "missing.md", status=2)

    def test_dependencies_that_are_no_xml_are_an_error(self):
        damaged = "#Dependencies:\n```xml\n<Tables\n```\n"
        case = "# DwellSyntax\n## damaged\n#BeforeBuild:\n```json\n{}\n```\n#AfterBuild:\n```json\n{}\n```\n"
        file = ("# HeidenhainDatumTable\n## damaged\n#File: ZERO.D\n```\nBEGIN ZERO.D\n[END]\n```\n"
                "#Tables:\n```xml\n```\n")
        for text in (case, file):
            page = self.write("c.md", text + damaged)
            self.assertIn("the dependencies are no XML", self.run_it("case", page, status=1).stdout)

    @unittest.skipIf(FACTOR < 1, "the tests cases_* run the same pages")
    def test_shipped_pages_hold(self):
        self.assertIn(" 0 fail", self.run_it("case", "--all", timeout=300).stdout)  # sanitizers take their time


class KeptTables(Command):
    def test_variables_are_kept_from_run_to_run(self):
        program = self.write("count.nc", "O1\n#500=#500+1\n#501=#0\n#502=2\nX#500\nM30\n")
        given = self.write("given.xml", '<MacroVariables>\n  <Variable number="500" Value="6.5"/>\n'
                                        '  <Variable number="501" Value="1"/>\n</MacroVariables>\n')
        for x in (7.5, 8.5):
            done = self.run_it("run", program, "-d", "fanuc", "--variables", given, "--save-table",
                               f"MacroVariables={given}")
            self.assertEqual(json.loads(done.stdout.splitlines()[0])["ProgramXyz"]["X"], x)
            kept = given.read_text()
            self.assertIn(f'<Variable number="500" Value="{x}" />', kept)
            self.assertIn('<Variable number="501" Value="1" Null="1" />', kept)
            self.assertIn('<Variable number="502" Value="2" />', kept)

    def test_offsets_are_written_as_the_program_left_them(self):
        program = self.write("measure.nc", "G10 L2 P2 X12.5\n#5223=-7\nM30\n")
        self.run_it("run", program, "-d", "fanuc", "--save-table", "IsoCoordinateTable=after.xml", "--emit", "none")
        after = (self.path / "after.xml").read_text()
        self.assertIn('<Offset id="G54" X="0" Y="0" Z="-7" />', after)
        self.assertIn('<Offset id="G55" X="12.5" Y="0" Z="0" />', after)

    def test_what_cannot_be_saved_is_said(self):
        for request, code, status in (("MacroVariables", "IG-0513", 2), ("Nothing=x.xml", "IG-0513", 1),
                                      ("MacroVariables=no/folder/x.xml", "IG-0511", 2)):
            done = self.run_it("run", self.program, "-d", "fanuc", "--save-table", request, "--emit", "none",
                               status=status)
            self.assertIn(code, done.stderr)


class Faults(Command):
    def setUp(self):
        super().setUp()
        self.dialect = self.write("bad.xml", '<Dialect xmlns="urn:isogloss:dialect:1" name="bad" extends="iso">'
                                             '<Plugins><Plugin name="cli_bad_plugin"/></Plugins><Chain>'
                                             '<InsertBefore syntax="WordSyntax"><MisbehaveSyntax/></InsertBefore>'
                                             "</Chain></Dialect>")

    def fault(self, block, *more):
        program = self.write("fault.nc", f"G90 G54\nG00 X1. Y2. Z3.\n{block}\nG00 X9.\n")
        return self.run_it("run", program, "-d", self.dialect, "--plugins", OPTIONS.bad_plugins, *more, status=3)

    def reproducer(self, *more, status):
        pages = list(self.path.glob("isogloss-crash-*.md"))
        self.assertEqual(len(pages), 1)
        page = pages[0].read_text()
        done = self.run_it("case", pages[0], "-d", self.dialect, "--plugins", OPTIONS.bad_plugins, *more,
                           status=status)
        return page, done

    def test_a_crash_names_its_place_and_is_repeatable(self):
        done = self.fault("G00 X5. M901")
        self.assertIn("internal fault: segmentation fault in MisbehaveSyntax of plugin cli_bad_plugin", done.stderr)
        self.assertIn("fault.nc:3: G00 X5. M901", done.stderr)
        page, again = self.reproducer(status=3)
        self.assertIn("# MisbehaveSyntax", page)
        self.assertIn('"M901"', page)
        self.assertIn('"ProgramXyz"', page)
        self.assertIn("MisbehaveSyntax", again.stderr)

    def test_an_abort_and_a_crashing_scanner(self):
        self.assertIn("abort in MisbehaveSyntax", self.fault("M904").stderr)
        for page in self.path.glob("isogloss-crash-*.md"):
            page.unlink()
        self.assertIn("fault.nc:3: G00 X5. ?", self.fault("G00 X5. ?").stderr)
        self.assertIn("G00 X5. ?", self.reproducer(status=3)[0])

    def test_a_hang_ends(self):
        begin = time.monotonic()
        done = self.fault("G00 X5. M902", "--watchdog", "1")
        self.assertLess(time.monotonic() - begin, 20)
        self.assertIn("no end of the block in sight in MisbehaveSyntax", done.stderr)
        self.assertEqual(len(list(self.path.glob("isogloss-crash-*.md"))), 1)

    def test_a_hang_in_either_run_of_a_comparison_ends(self):
        quiet, hangs = self.write("quiet.nc", "G00 X5.\n"), self.write("hangs.nc", "G00 X5. M902\n")
        for pair in ((quiet, hangs), (hangs, quiet)):
            for more in ([], ["--motions"]):
                done = self.run_it("diff", *pair, "-d", self.dialect, "--plugins", OPTIONS.bad_plugins, "--watchdog", "1",
                                   *more, status=3)
                self.assertIn("no end of the block in sight in MisbehaveSyntax", done.stderr)

    def test_an_exception_is_a_fault_and_the_run_goes_on(self):
        done = self.fault("M903")
        self.assertIn("thrown on purpose", done.stderr)
        self.assertIn("[IG-0401]", done.stderr)
        self.assertEqual(json.loads(done.stdout.splitlines()[-1])["ProgramXyz"]["X"], 9)

    def test_no_temporary_file_is_left(self):
        self.fault("M901", "-o", self.path / "out.jsonl")
        self.assertEqual([p.name for p in self.path.iterdir() if p.name.startswith("out")], [])


class Signals(Command):
    """Signals that end a run, and slow readers."""
    def start(self, *arguments, lines=200_000, line="G01 X{x}. Y2.", **pipes):
        program = self.write("long.nc", "F1000\n" + "".join(line.format(x=i % 90) + "\n" for i in range(lines)))
        return subprocess.Popen([OPTIONS.isogloss, "run", program, "-d", "fanuc", *map(str, arguments)], **pipes)

    def test_who_reads_slowly_gets_whole_lines(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            process = self.start(stdout=subprocess.PIPE)
            with process.stdout:
                last = process.stdout.read(1000)
                time.sleep(0.3)  # the pipe is full, and a write waits for its reader
                process.send_signal(number)
                time.sleep(0.1)
                while piece := process.stdout.read(1000):
                    last = (last + piece)[-1000:]
            self.assertEqual(process.wait(timeout=20), -number)
            self.assertTrue(last.endswith(b"}\n"), last[-100:])

    def test_no_temporary_file_is_left(self):
        # Often, and at once when the file is there: the process may be about to note that the file is to be removed.
        for number in (signal.SIGTERM, signal.SIGQUIT, signal.SIGXCPU) * 20:
            process = self.start("-o", self.path / "out.jsonl", "-", lines=100, stdin=subprocess.PIPE,
                                 stderr=subprocess.DEVNULL)  # waits for its last program
            with process.stdin:
                deadline = time.monotonic() + 20
                while not list(self.path.glob("out.jsonl.*")) and time.monotonic() < deadline:
                    pass
                process.send_signal(number)
                self.assertEqual(process.wait(timeout=20), -number)
            self.assertEqual(list(self.path.glob("out.jsonl*")), [])

    def test_a_file_that_grows_too_large_is_said(self):
        process = self.start("-o", self.path / "out.jsonl", stderr=subprocess.PIPE, text=True,
                             preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000)))
        self.assertIn("IG-0511", process.communicate(timeout=60)[1])
        self.assertEqual(process.returncode, 2)
        self.assertEqual(list(self.path.glob("out.jsonl*")), [])

    def test_a_reader_of_diagnostics_that_pauses_is_no_fault_of_a_syntax(self):
        process = self.start("--watchdog", "1", "--repeats", "0", "--emit", "none", lines=5000, line="G123",
                             stderr=subprocess.PIPE, text=True)
        time.sleep(3.5)
        self.assertNotIn("internal fault", process.communicate(timeout=60)[1])
        self.assertEqual(process.returncode, 1)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--isogloss", required=True, type=lambda p: str(pathlib.Path(p).resolve()))
    parser.add_argument("--bad-plugins", required=True, type=lambda p: str(pathlib.Path(p).resolve()))
    parser.add_argument("--seconds", type=float, default=4, help="that an endless program may take")
    OPTIONS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest], verbosity=1)
