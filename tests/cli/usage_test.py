#!/usr/bin/env python3
"""What a command is given has an effect, or is refused: options, patterns, outputs.

  usage_test.py --isogloss PATH [unittest's own options]
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

OPTIONS = None
PROGRAM = "O0001\nG21 G90 G17 G54\nG00 X10. Y0. Z5.\nG01 Z-1. F120.\nM30\n"
PAGE = """# DwellSyntax
## P in seconds
#BeforeBuild:
```json
{"Parsing": {"G04": {"P": 0.5}}}
```
#AfterBuild:
```json
{"Dwell": {"Time": 0.5}}
```
"""
DIALECT = '<Dialect xmlns="urn:isogloss:dialect:1" name="mine" title="Mine" extends="fanuc"></Dialect>\n'


class Command(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        for name, text in (("part.nc", PROGRAM), ("page.md", PAGE), ("mine.xml", DIALECT), ("block.json", "{}"),
                           ("archive/part.nc", PROGRAM)):
            (self.path / name).parent.mkdir(exist_ok=True)
            (self.path / name).write_text(text)
        self.isogloss("run", "part.nc", "-d", "fanuc", "--format", "binary", "-o", "part.igm")

    def isogloss(self, *arguments, status=0, given="{}", output=subprocess.PIPE, errors=subprocess.PIPE):
        environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")}
        done = subprocess.run([OPTIONS.isogloss, *map(str, arguments)], stdout=output, stderr=errors, input=given, text=True,
                              timeout=120, check=False, cwd=self.path, env=environment)
        self.assertEqual(done.returncode, status, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done


class IdleOptions(Command):
    def test_options_that_leave_each_other_no_effect_are_refused_by_name(self):
        part, fanuc = "part.nc", ("-d", "fanuc")
        for arguments, first, second in (
                (("diff", *fanuc, part, part, "--motions", "--ignore", "Comment"), "--ignore", "--motions"),
                (("batch", "archive", "-o", "out", "--slurm-options=x"), "--slurm-options", "--slurm"),
                (("batch", "archive", "-o", "out", "--no-submit"), "--no-submit", "--slurm"),
                (("batch", "archive", "-o", "out", "--merge", "--retry"), "--retry", "--merge"),
                (("batch", "archive", "-o", "out", "--merge", "-j", "2"), "--jobs", "--merge"),
                (("batch", "archive", "-o", "out", "--merge", "--changed-since", "x"), "--changed-since", "--merge"),
                (("motions", "part.igm", "--json", "--format", "text"), "--json", "--format text"),
                (("case", "page.md", "--json", "--junit"), "--junit", "--json"),
                (("case", "page.md", "--junit", "--format", "text"), "--junit", "--format text"),
                (("validate", "--list", "--json", "--format", "sarif"), "--json", "--format sarif"),
                (("validate", "--list", "--strict"), "--strict", "--list"),
                (("validate", "x.so", "--in-process", "--time-limit", "5"), "--time-limit", "--in-process"),
                (("explain", part, *fanuc, "--field", "Feedrate", "--brief"), "--brief", "--field"),
                (("explain", part, *fanuc, "--field", "Feedrate", "--all"), "--all", "--field"),
                (("explain", part, *fanuc, "--field", "Feedrate", "--pass", "2"), "--pass", "--field"),
                (("explain", "IG-0206", *fanuc), "--dialect", "IG-0206"),
                (("explain", "IG-0206", "--brief"), "--brief", "IG-0206"),
                (("diff", *fanuc, "-a", "iso", "-b", "haas", part), "-d", "each side"),
                (("diff", "-m", "fanuc-mill", "-a", "iso", "-b", "haas", part), "-m", "each side"),
                (("diff", *fanuc, "--machine-a", "fanuc-mill", "-b", "haas", part), "-d", "each side"),
                (("view", *fanuc, "-a", "iso", "-b", "haas", part), "-d", "each side"),
                (("manual", "run", "-o", "pages"), "--output", "COMMAND")):
            with self.subTest(arguments=arguments):
                done = self.isogloss(*arguments, status=2)
                self.assertEqual(done.stdout, "")
                self.assertIn(first + " ", done.stderr)
                self.assertIn(second, done.stderr)
        self.assertFalse((self.path / "out").exists())

    def test_options_that_no_chosen_check_has_a_use_for_are_told(self):
        options = ("--seed", "--blocks", "--random-limit", "--budget")
        values = [word for option in options for word in (option, "7")]
        for checks, idle in ((("loads",), options), (("loads", "options"), options[1:]), (("random-blocks",), options[3:]),
                             (("time", "random-blocks"), ())):
            only = [word for check in checks for word in ("--only", check)]
            told = self.isogloss("validate", "no.so", *only, *values, status=2).stderr
            for option in options:
                self.assertEqual(f"{option} has no effect" in told, option in idle, told)
        self.assertNotIn("IG-0519", self.isogloss("validate", "no.so", *values, status=2).stderr)

    def test_a_range_beyond_the_end_of_the_file_is_told(self):
        for more in ((), ("--field", "Feedrate")):
            done = self.isogloss("explain", "part.nc:3-99", "-d", "fanuc", *more)
            self.assertIn("part.nc:5: note: the range goes to line 99, but the file has 5 lines [IG-0521]", done.stderr)
            self.assertEqual(self.isogloss("explain", "part.nc:3-5", "-d", "fanuc", *more).stderr, "")

    def test_values_that_no_syntax_reads_are_told(self):
        (self.path / "parameters.xml").write_text('<FanucParameterTable>\n<Parameter number="99999" Value="1"/>\n'
                                                  '<Parameter number="5115" Value="500"/></FanucParameterTable>\n')
        for arguments, place in ((("--set", "FanucParameterTable.99999=1"), "--set"),
                                 (("--machine", "parameters.xml"), "parameters.xml:2:")):
            done = self.isogloss("run", "part.nc", "-d", "fanuc", "--emit", "none", *arguments)
            self.assertRegex(done.stderr, rf"{place}.*FanucParameterTable has no use for 99999: .*\[IG-0613\]")
        done = self.isogloss("run", "part.nc", "-d", "fanuc", "--emit", "none", "--set", "FanucParameterTable.5115=1")
        self.assertEqual(done.stderr, "")

    def test_options_that_go_together_are_not_refused(self):
        for arguments in (("motions", "part.igm", "--json", "--format", "jsonl"), ("case", "page.md", "--json"),
                          ("validate", "--list", "--json", "--only", "loads"), ("explain", "IG-0206", "--json", "--werror"),
                          ("diff", "-d", "fanuc", "-a", "fanuc", "part.nc"), ("diff", "-m", "ac-table", "-a", "fanuc", "-b",
                                                                              "fanuc", "part.nc"),
                          ("view", "-d", "fanuc", "-a", "fanuc", "part.nc", "-o", "view.html")):
            self.isogloss(*arguments)

    def test_a_value_that_is_empty_or_doubled_is_refused(self):
        for arguments, what in ((("run", "part.nc", "-d", ""), "--dialect: its value is empty"),
                                (("run", "part.nc", "-o", ""), "--output: its value is empty"),
                                (("run", "part.nc", "--set", ""), "--set: its value is empty"),
                                (("run", "part.nc", "--set", "A.B=1", "--set", "A.B=2"), "--set gives A.B two values"),
                                (("explain", "-:3"), "no option '-:': write -- before"),
                                (("apply", "DwellSyntax", "--ahead", "-"), "standard input is the block itself"),
                                (("run", ""), "PROGRAM: its value is empty"),
                                (("run", "part.nc", "-d", "fanuc", "-d", "iso"),
                                 "--dialect takes one value and is given 2 times")):
            self.assertIn(what, self.isogloss(*arguments, status=2).stderr)

    def test_an_option_that_what_is_shown_has_no_use_for_is_told(self):
        for name in ("fanuc-mill", "iso", "Feedrate.FeedrateValue", "FanucOffsets"):
            self.assertIn("--dialect has no effect", self.isogloss("inspect", name, "-d", "fanuc").stderr)
        self.assertEqual(self.isogloss("inspect", "DwellSyntax", "-d", "fanuc").stderr, "")

        self.assertIn("--max-output has no effect", self.isogloss("run", "part.nc", "-d", "fanuc", "--emit", "none",
                                                                  "--max-output", "5").stderr)

    def test_help_of_a_command_is_that_of_its_option(self):
        self.assertEqual(self.isogloss("help", "run").stdout, self.isogloss("run", "--help").stdout)
        self.isogloss("help", "runn", status=2)

    def test_what_is_no_stream_makes_no_table(self):
        done = self.isogloss("motions", "part.nc", status=1)
        self.assertEqual(done.stdout, "")
        self.assertIn("[IG-0640]", done.stderr)

    def test_patterns_that_choose_nothing_are_told(self):
        done = self.isogloss("batch", "archive/part.nc", "--exclude", "*.txt", "-d", "fanuc", "-o", "out", status=2)
        self.assertIn("--exclude has no effect", done.stderr)
        done = self.isogloss("batch", "archive", "--include", "*.nc", "--exclude", "*.txt", "-d", "fanuc", "-o", "out")
        self.assertIn("--exclude *.txt has no effect", done.stderr)
        self.assertNotIn("--include", done.stderr)


class Outputs(Command):
    COMMANDS = (("run", "part.nc", "-d", "fanuc"), ("run", "part.nc", "-d", "fanuc", "--emit", "none"),
                ("explain", "part.nc:3", "-d", "fanuc"), ("explain", "part.nc", "-d", "fanuc", "--field", "Feedrate"),
                ("explain", "IG-0206"), ("state", "part.nc:3", "-d", "fanuc"),
                ("state", "part.nc:4", "-d", "fanuc", "--as-preamble"), ("batch", "archive", "-d", "fanuc", "-o", "out"),
                ("diff", "-d", "fanuc", "part.nc", "part.nc"), ("motions", "part.igm"), ("plot", "part.nc", "-d", "fanuc"),
                ("view", "part.nc", "-d", "fanuc"), ("lint", "fanuc"), ("dialect", "fanuc"), ("schema", "motion"),
                ("list", "dialects"), ("inspect", "fanuc"), ("docs", "-o", "reference"), ("new", "machine", "hall", "-d", "fanuc"),
                ("doctor",), ("apply", "DwellSyntax"), ("case", "page.md"), ("validate", "--list"), ("--version",))

    def test_diagnostics_that_cannot_be_written_are_2_in_every_command(self):
        for arguments in self.COMMANDS:
            for file in ("/dev/full", "no/such/folder/x"):
                with self.subTest(arguments=arguments, file=file):
                    done = self.isogloss(*arguments, "--diagnostics", "sarif", "--diagnostics-output", file, status=2)
                    self.assertIn("cannot be written: ", done.stderr.replace("\\u", ""))

    @unittest.skipUnless(sys.platform == "linux", "who reads --untrusted programs is confined on Linux alone")
    def test_diagnostics_of_untrusted_work_that_cannot_be_written_are_2(self):
        self.isogloss("run", "part.nc", "-d", "fanuc", "--untrusted", "--diagnostics", "sarif", "--diagnostics-output",
                      "/dev/full", status=2)

    def test_diagnostics_that_standard_error_cannot_take_are_2(self):
        (self.path / "wrong.nc").write_text("G21\nG200 X1.\nM30\n")
        for arguments in (("run", "wrong.nc", "-d", "fanuc", "--emit", "none"), ("lint", "nothing")):
            with open("/dev/full", "w", encoding="ascii") as full:
                self.isogloss(*arguments, status=2, errors=full)

    def test_a_reader_of_messages_that_went_away_is_no_fault(self):
        (self.path / "wrong.nc").write_text("G21\nG200 X1.\nG0 X5.\nM30\n")
        (self.path / "TOOL.T").write_text("BEGIN TOOL.T MM\nT NAME L R\n1 MILL +10 +5\n[END]\n")
        for arguments, status in ((("run", "wrong.nc", "-d", "fanuc"), 1), (("import", "TOOL.T"), 0),
                                  (("new", "dialect", "acme"), 0), (("batch", "archive", "-d", "fanuc", "-o", "out"), 0)):
            read_end, write_end = os.pipe()
            os.close(read_end)
            self.isogloss(*arguments, status=status, errors=write_end)
            os.close(write_end)

    def test_a_closed_standard_stream_does_not_become_the_output(self):
        (self.path / "wrong.nc").write_text("G21\nG200 X1.\nG0 X5.\nM30\n")
        run = f"'{OPTIONS.isogloss}' run wrong.nc -d fanuc --format csv"
        for streams, status in (("2>&-", 1), (">&- 2>&-", 1), ("<&- >&- 2>&-", 1)):
            self.isogloss("run", "wrong.nc", "-d", "fanuc", "--format", "csv", "-o", "wanted.csv", status=1)
            done = subprocess.run(f"{run} -o out.csv {streams}", shell=True, cwd=self.path, check=False)
            self.assertEqual(done.returncode, status, streams)
            self.assertEqual((self.path / "out.csv").read_text(), (self.path / "wanted.csv").read_text())
        self.assertEqual(subprocess.run(f"{run} >&- 2>&-", shell=True, cwd=self.path, check=False).returncode, 2)

    def test_no_diagnostics_replace_what_a_command_reads(self):
        for file, *arguments in (("part.nc", "explain", "part.nc:3", "-d", "fanuc"), ("part.nc", "state", "part.nc:3"),
                                 ("part.nc", "diff", "-a", "fanuc", "-b", "iso", "part.nc"),
                                 ("mine.xml", "diff", "-a", "fanuc", "-b", "mine.xml", "part.nc"),
                                 ("mine.xml", "lint", "mine.xml"), ("mine.xml", "dialect", "mine.xml"),
                                 ("mine.xml", "dialect", "fanuc", "--diff", "mine.xml"),
                                 ("mine.xml", "inspect", "./mine.xml"), ("page.md", "case", "page.md"),
                                 ("block.json", "apply", "DwellSyntax", "--previous", "block.json"),
                                 ("archive/part.nc", "batch", "archive/part.nc", "-d", "fanuc", "-o", "out")):
            with self.subTest(arguments=arguments):
                before = (self.path / file).read_bytes()
                done = self.isogloss(*arguments, "--diagnostics-output", file, status=2)
                self.assertIn("[IG-0530]", done.stderr)
                self.assertEqual((self.path / file).read_bytes(), before)

    def test_a_dialect_as_one_file_does_not_replace_itself(self):
        (self.path / "tools.xml").write_text('<ToolOffsetTable><Tool id="1" H="3"/></ToolOffsetTable>')
        (self.path / "mine.xml").write_text(DIALECT.replace(
            "></Dialect>", '><Dependencies><ToolOffsetTable src="tools.xml"/></Dependencies></Dialect>'))
        for more in (("-o", "mine.xml"), ("-o", "tools.xml"), ("-o", "whole.xml", "--base-directory", ".")):
            self.assertIn("[IG-0530]", self.isogloss("dialect", "mine.xml", *more, status=2).stderr)
        self.assertEqual((self.path / "mine.xml").read_text().count("extends"), 1)
        self.assertFalse((self.path / "whole.xml").exists())


class Cases(Command):
    """What a syntax removes is told by null."""
    PAGE = """# PolarCoordinateSyntax
## G15
#Previous:
```json
{ "PolarCoordinate": { "Term": "G16", "Radius": 100, "Angle_deg": 30 } }
```
#BeforeBuild:
```json
{ "Parsing": { "Flags": ["%s"] } }
```
#AfterBuild:
```json
%s
```
"""

    def case(self, code, after, status=0):
        (self.path / "polar.md").write_text(self.PAGE % (code, after))
        return self.isogloss("case", "polar.md", status=status)

    def test_a_null_holds_where_the_syntax_removes_what_was_there(self):
        self.case("G15", '{ "PolarCoordinate": null }')
        self.case("G15", '{ "PolarCoordinate": { "Radius": null, "Angle_deg": null } }')

    def test_a_null_does_not_hold_where_the_value_stays(self):
        done = self.case("G91", '{ "Parsing": { "Flags": ["G91"] }, "PolarCoordinate": null }', status=1)
        self.assertIn('PolarCoordinate: expected null, got {"Term":"G16"', done.stdout)
        done = self.case("G91", '{ "Parsing": { "Flags": ["G91"] }, "PolarCoordinate": { "Radius": null } }', status=1)
        self.assertIn("PolarCoordinate.Radius: expected null, got 100", done.stdout)

    def test_a_null_of_what_was_not_there_is_a_fault_of_the_page(self):
        for path, after in (("Dwell", '{ "Dwell": null }'),
                            ("PolarCoordinate.Pole", '{ "PolarCoordinate": { "Term": null, "Pole": null } }')):
            done = self.case("G15", after, status=1)
            self.assertIn(f"null for {path}, which is not there before the build [IG-0501]", done.stdout)

    def test_a_fault_of_json_is_told_at_its_own_fence(self):
        (self.path / "polar.md").write_text((self.PAGE % ("G15", "{}")).replace('"Radius"', '"Radius":'))
        self.assertIn("polar.md:5:", self.isogloss("case", "polar.md", status=1).stdout)
        (self.path / "block.json").write_text('{\n"A":: 1}')
        self.assertIn("block.json:2:5: error", self.isogloss("apply", "DwellSyntax", "--previous", "block.json",
                                                             status=1).stderr)
        self.assertEqual(json.loads(self.isogloss("apply", "DwellSyntax").stdout), {})


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.isogloss = str(OPTIONS.isogloss.resolve())
    unittest.main(argv=[sys.argv[0], *rest])
