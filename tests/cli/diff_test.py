#!/usr/bin/env python3
"""isogloss diff: where two dialects, settings or programs part, which cause is named, and what it costs.

  diff_test.py --isogloss PATH
"""
import argparse
import html.parser
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import jsonschema
except ImportError:  # the other tests do not need it
    jsonschema = None

OPTIONS = None
SCHEMA = json.loads((pathlib.Path(__file__).resolve().parents[2] / "schemas/diff.schema.json").read_text())

HEAD = "G21 G90 G54 G94\nM3 S1000\nG0 X0. Y0. Z50.\n"
PECKS = HEAD + "G99 G83 X10. Y10. Z-20. R2. Q5. F200.\nX20.\nX30.\nG80\nG0 Z50.\nM30\n"
CLEARANCE = ["--set-b", "SyntecParameterTable.4002=500"]


def mill(lines):
    """A program without holes: as many moves as wanted."""
    return HEAD + "".join(f"G1 X{i % 100}.{i % 7} Y{i // 100}. F300.\n" for i in range(lines)) + "M30\n"


class Page(html.parser.HTMLParser):
    """The tags that are open, and all that a browser would load."""
    def __init__(self):
        super().__init__()
        self.open, self.loads = [], []

    def handle_starttag(self, tag, attrs):
        if tag not in ("meta", "br"):
            self.open.append(tag)
        self.loads += [value for name, value in attrs if name in ("src", "href")]

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag


class Diff(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def write(self, name, text):
        path = self.path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def diff(self, *arguments, status=1, **more):
        environment = {k: v for k, v in os.environ.items() if not k.startswith(("ISOGLOSS_", "XDG_"))}
        environment["HOME"] = str(self.path / "home")
        done = subprocess.run([OPTIONS.isogloss, "diff", *map(str, arguments)], capture_output=True, text=True,
                              timeout=120, check=False, cwd=self.path, env=environment, **more)
        if status is not None:
            self.assertEqual(done.returncode, status, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done

    def causes(self, *arguments, **more):
        """The causes of the only comparison, and the comparison itself."""
        done = json.loads(self.diff(*arguments, "--json", **more).stdout)
        if jsonschema is not None:
            jsonschema.validate(done, SCHEMA)
        self.assertEqual(done["IsoglossDiff"], 1)
        [comparison] = done["Comparisons"]
        self.assertEqual(comparison["Same"], comparison["Different"] == 0)
        return comparison.get("Causes"), comparison

    def test_the_clearance_of_two_controls_is_the_cause(self):
        part = self.write("part.nc", PECKS)
        causes, whole = self.causes("-a", "fanuc", "-b", "syntec", *CLEARANCE, part)
        self.assertEqual(whole["Different"], 3)
        cause = causes[0]
        self.assertEqual(cause["Blocks"], 3)
        self.assertEqual(cause["Cause"], "G83 peck clearance: 5115 = 1 mm against Pr4002 = 0.5 mm")
        self.assertEqual(cause["Evidence"][0]["Title"], "peck clearance")
        self.assertEqual(cause["SyntaxA"], "PeckDrillingCycleSyntax")
        [values] = [e["Values"] for e in cause["Examples"] if e["A"]["Line"] == 4]
        depths = [(v["A"], v["B"]) for v in values if v["Field"].endswith("].ProgramXyz.Z")]
        self.assertIn(("-2", "-2.5"), depths, "it stops 1 mm, and half a millimetre, above the last peck")
        fields = {f["Path"]: f for f in cause["Fields"]}
        self.assertTrue(fields["CompoundMotion.Items[].ProgramXyz.Z"]["IsDirect"])
        self.assertFalse(fields["CompoundMotion.Items[].MachineCoordinate.Z"]["IsDirect"], "it follows")
        text = self.diff("-a", "fanuc", "-b", "syntec", *CLEARANCE, part).stdout
        self.assertIn("\nG83 peck clearance: 5115 = 1 mm against Pr4002 = 0.5 mm: 3 blocks\n", text)

    def test_the_unit_of_a_parameter_is_that_of_its_control(self):
        part = self.write("part.nc", PECKS)
        causes, _ = self.causes("-d", "fanuc", "--set-b", "FanucParameterTable.5115=250", part)
        self.assertIn("peck clearance: 5115 = 1 mm against 0.25 mm", causes[0]["Cause"])

    def test_rows_are_tried_as_options_are(self):
        part = self.write("part.nc", PECKS)
        # The cycle reads 1013 for the size of an increment; bit 2 means nothing.
        both = ["--set-b", "FanucParameterTable.5115=500", "--set-b", "FanucParameterTable.1013=4"]
        causes, _ = self.causes("-d", "fanuc", *both, part)
        tried = [e for c in causes for e in c["Evidence"] if e["Trial"] is not None]
        self.assertEqual({(e["NameA"], e["Trial"]) for e in tried}, {("5115", "Cause"), ("1013", "NoCause")}, causes)
        self.assertIn("tried:", self.diff("-d", "fanuc", *both, part).stdout)

    def test_the_cause_acts_before_the_syntax_that_writes_last(self):
        """Inches become mm on both sides alike; the number was another one before."""
        part = self.write("inch.nc", "G20 G90\nG00 X3 Y4.\nM30\n")
        [cause] = [c for c in self.causes(part, "-a", "iso", "-b", "fanuc")[0] if c["Kind"] != "Diagnostic"]
        self.assertEqual(cause["Cause"], "option rule of DecimalPointSyntax = as-written against parameter")
        self.assertTrue(cause["IsTried"])

    def test_a_code_that_one_side_does_not_know(self):
        part = self.write("coolant.nc", "G21 G90\nM88\nG00 X3.\nM89\nM30\n")
        cause = self.causes(part, "-a", "fanuc", "-b", "haas")[0][0]
        self.assertEqual((cause["Cause"], cause["Kind"], cause["SyntaxA"], cause["SyntaxB"], cause["IsTried"]),
                         ("HaasCoolantSyntax, which only haas has", "Syntaxes", None, "HaasCoolantSyntax", True))
        self.assertIn("    tried:    without it on both sides the block is the same\n",
                      self.diff(part, "-a", "fanuc", "-b", "haas").stdout)

    def test_the_same_on_both_sides_is_no_difference(self):
        part = self.write("part.nc", PECKS)
        for sides in (["-a", "fanuc", "-b", "fanuc"], ["-a", "fanuc", "-b", "syntec"]):
            self.assertIn("no difference", self.diff(*sides, part, status=0).stdout)
            self.assertEqual(self.causes(*sides, part, status=0)[0], [])
        self.assertIn("no difference", self.diff("-d", "fanuc", part, self.write("copy.nc", PECKS), status=0).stdout)

    def test_one_option_of_a_dialect_is_the_cause(self):
        chain = '<Chain><Configure syntax="DwellSyntax" p-unit="s"/></Chain>'
        for name, chain_of in (("ms", ""), ("s", chain)):
            self.write(f"{name}.xml", '<Dialect xmlns="urn:isogloss:dialect:1" '
                       f'name="{name}" title="Mine" extends="fanuc">{chain_of}</Dialect>')
        part = self.write("part.nc", HEAD + "G4 P500\nG0 X1.\nG4 X2.\nM30\n")
        causes, whole = self.causes("-a", "./ms.xml", "-b", "./s.xml", part)
        self.assertEqual(whole["Different"], 1)
        [cause] = [c for c in causes if c["Kind"] == "Syntax"]
        self.assertIn("option p-unit of DwellSyntax = ms against s", cause["Cause"])
        self.assertEqual(cause["Evidence"][0]["PlaceB"].rsplit("/", 1)[-1], "s.xml:1")
        [value] = [v for v in cause["Examples"][0]["Values"] if v["Field"].startswith("Dwell")][:1]
        self.assertEqual((value["A"], value["B"]), ("0.5", "500"))

    def test_a_row_of_a_table_is_the_cause_of_all_that_follows(self):
        part = self.write("part.nc", HEAD + "G0 X1.\nG55 X2.\nX3.\nG54 X4.\nM30\n")
        causes, whole = self.causes("-d", "fanuc", "--set-b", "IsoCoordinateTable.G55.X=7", part)
        self.assertEqual(len(causes), 1, causes)
        self.assertIn("IsoCoordinateTable G55", causes[0]["Cause"])
        self.assertEqual(whole["Different"], 2, "the two lines under G55")

    def test_two_programs(self):
        old = self.write("old.nc", mill(50))
        lines = mill(50).splitlines()
        lines[10] = lines[10].replace("F300.", "F250.")
        lines.insert(30, "G1 X77.")
        new = self.write("new.nc", "\n".join(lines) + "\n")
        causes, whole = self.causes("-d", "fanuc", old, new)
        by_kind = {c["Kind"]: c for c in causes}
        self.assertEqual(by_kind["Blocks"]["Blocks"], 1)
        self.assertEqual(by_kind["Blocks"]["Examples"][0]["B"], {"File": str(new), "Line": 31, "Text": "G1 X77."})
        feed = [c for c in causes if "Parsing.F" in c["Cause"]][0]
        self.assertEqual((feed["Kind"], feed["Blocks"]), ("Text", 1))
        self.assertEqual({e["A"]["Line"] for e in feed["Examples"]}, {11})
        self.assertEqual(whole["Different"], 2, "what follows the new line is where it was")

    def test_lines_with_new_numbers_stay_together(self):
        body = [f"G1 X{i}. F300." for i in range(400)]
        old = "".join(f"N{i * 10} {line}\n" for i, line in enumerate(body))
        body[200:200] = ["G1 Y5."]
        body[300:300] = ["G1 Y0."]
        new = "".join(f"N{i * 10} {line}\n" for i, line in enumerate(body))
        causes, whole = self.causes("-d", "fanuc", "--ignore", "Source.N", "--ignore", "Parsing.N",
                                    self.write("old.nc", old), self.write("new.nc", new))
        self.assertEqual(sum(c["DirectBlocks"] for c in causes if c["Kind"] == "Blocks"), 2, causes)
        done = self.diff("-d", "fanuc", "--ignore", "Sauce", "old.nc", "old.nc", status=0)
        self.assertIn("[IG-0189]", done.stderr)

    def test_calls_and_loops_that_part_come_together_again(self):
        part = self.write("part.nc", HEAD + "M98 P100 L3\nG0 X5.\nM30\nO100\nG91 G0 X1.\nG90\nM99\n")
        other = self.write("other.nc", HEAD + "M98 P100 L2\nG0 X5.\nM30\nO100\nG91 G0 X1.\nG90\nM99\n")
        causes, _ = self.causes("-d", "fanuc", part, other)
        alone = [c for c in causes if c["Kind"] == "Blocks"]
        self.assertEqual(len(alone), 1, "only one side makes the third pass")
        self.assertLessEqual(alone[0]["Blocks"], 4)

    def test_what_only_one_side_reports(self):
        part = self.write("part.nc", HEAD + "G64.7\nG0 X1.\nG120.1 P1\nM30\n")
        causes, _ = self.causes("-a", "fanuc", "-b", "syntec", part)
        reports = [c for c in causes if c["Kind"] == "Diagnostic"]
        self.assertTrue(any("only fanuc reports" in c["Cause"] for c in reports), causes)
        self.assertTrue(all(c["Examples"][0]["A"]["Line"] == 6 for c in reports), reports)
        self.assertIn("[IG-0187]", self.diff("-a", "fanuc", "-b", "fanuc", part, status=0).stderr)

    def test_a_report_with_other_values(self):
        part = self.write("part.nc", HEAD + "G99 G83 X1. Y1. Z-9. R2. Q0.1 F200.\nG80\nM30\n")
        causes, _ = self.causes("-d", "fanuc", "--set-b", "FanucParameterTable.5115=500", part)
        [report] = [c for c in causes if c["Kind"] == "Diagnostic"]
        self.assertEqual(report["Cause"], "ISO-0333 (warning) with other values")
        [values] = report["Examples"][0]["Values"]
        self.assertIn("of 1 mm", values["A"])
        self.assertIn("of 0.5 mm", values["B"])

    def test_motions_within_a_tolerance(self):
        old = self.write("old.nc", HEAD + "G1 X10. F300.\nG1 X20.\nG1 A10.\nM30\n")
        new = self.write("new.nc", HEAD + "G1 X10.004 F300.\nG1 X20.008\nG1 A10.02\nM30\n")
        both = ["-d", "fanuc", old, new, "--motions"]
        text = self.diff(*both).stdout
        self.assertIn("machine position: 3 events", text)  # the last one stays 8 micrometres beside
        self.assertIn("(by 0.004 mm)", text)
        self.assertIn("(by 0.008 mm)", text)
        self.assertIn("rotary axes: 1 event", text)
        _, whole = self.causes(*both, "--tolerance", "0.005,0.01")
        kinds = {k["Kind"]: k for k in whole["Motions"]}
        self.assertAlmostEqual(kinds["machine position"]["Greatest"]["Size"], 0.008)
        self.assertAlmostEqual(kinds["rotary axes"]["First"]["Size"], 0.02)
        self.assertEqual(kinds["machine position"]["Events"], 2)
        self.diff(*both, "--tolerance", "0.0081,0.021", status=0)
        self.diff(*both, "--tolerance", "0.0081", status=1)
        self.diff(*both, "--tolerance", "1000", status=0)
        for wrong in ("-1", "1001", "1,", "x", "0.1,0.2,0.3"):
            done = self.diff(*both, f"--tolerance={wrong}", status=2)
            self.assertIn("[IG-0186]", done.stderr)
        self.assertIn("[IG-0186]", self.diff("-d", "fanuc", old, new, "--tolerance", "1", status=2).stderr)

    def test_motions_of_two_dialects(self):
        part = self.write("part.nc", PECKS)
        _, whole = self.causes("-a", "fanuc", "-b", "syntec", *CLEARANCE, "--motions", part)
        [kind] = [k for k in whole["Motions"] if k["Kind"] == "machine position"]
        self.assertAlmostEqual(kind["Greatest"]["Size"], 0.5)
        self.assertEqual(kind["First"]["A"], {"File": str(part), "Line": 4})

    def test_the_page_shows_text_of_programs_as_text(self):
        old = self.write("old.nc", HEAD + "G1 X1. F100. (<script>alert(1)</script>)\nM30\n")
        new = self.write("new.nc", HEAD + "G1 X2. F100. (<b>&amp;</b>)\nM30\n")
        self.diff("-d", "fanuc", old, new, "--html", "page.html", "--all")
        text = (self.path / "page.html").read_text()
        self.assertNotIn("<script", text)
        self.assertIn("&lt;script&gt;alert(1)", text)
        page = Page()
        page.feed(text)
        self.assertEqual((page.open, page.loads), ([], []), "well formed, and nothing is loaded")
        self.assertIn("[IG-0530]", self.diff("-d", "fanuc", old, new, "--html", old, status=2).stderr)

    def test_every_block_on_demand(self):
        part = self.write("part.nc", PECKS)
        sides = ["-a", "fanuc", "-b", "syntec", *CLEARANCE]
        _, whole = self.causes(*sides, "--all", part)
        self.assertEqual([block["A"]["Line"] for block in whole["All"]], [4, 5, 6])
        self.assertEqual({block["Cause"] for block in whole["All"]}, {0})
        self.assertNotIn("All", self.causes(*sides, part)[1])
        self.assertIn("All blocks that differ:", self.diff(*sides, "--all", part).stdout)

    def test_a_pipe(self):
        for sides in (["-a", "fanuc", "-b", "syntec", *CLEARANCE], ["-d", "fanuc", "--against", self.write("x.nc", HEAD)]):
            self.diff(*sides, "-", input=PECKS)
        self.diff("-a", "fanuc", "-b", "fanuc", "-", input=PECKS, status=0)
        with subprocess.Popen([OPTIONS.isogloss, "diff", "-a", "fanuc", "-b", "syntec", *CLEARANCE,
                               self.write("part.nc", PECKS), "--all"], stdout=subprocess.PIPE) as process:
            process.stdout.close()
            self.assertIn(process.wait(timeout=60), (1, 2))

    def test_errors_of_runs_whose_motions_agree(self):
        sound, broken = self.write("sound.nc", HEAD + "M30\n"), self.write("broken.nc", HEAD + "G777\nM30\n")
        done = self.diff(sound, broken, "-d", "fanuc", "--motions", status=0)
        self.assertRegex(done.stderr, r"broken.nc:4:1: warning: .*count: 1.*G777.*\[IG-0184\]")
        self.assertNotIn("sound.nc:", done.stderr)
        warnings = HEAD + "".join(f"G0 X{number}\n" for number in range(30))
        sound, broken = self.write("sound.nc", warnings + "M30\n"), self.write("late.nc", warnings + "G777\nM30\n")
        done = self.diff(sound, broken, "-d", "fanuc", "--motions", status=0)
        self.assertRegex(done.stderr, r"late.nc:34:1: warning: .*count: 1.*G777.*\[IG-0184\]")
        done = self.diff(sound, broken, "-d", "fanuc", "--motions", "--max-blocks", "2", status=0)
        self.assertEqual(done.stderr.count("[IG-0407] [IG-0184]"), 2)

    def test_tables_of_a_machine_lie_over_the_dialect_of_each_side(self):
        tables = self.write("shop.xml", '<Dependencies><IsoCoordinateTable><Offset id="G54" X="7"/></IsoCoordinateTable>'
                                        '</Dependencies>')
        part = self.write("part.nc", HEAD + "M30\n")
        sides = ("-a", "fanuc", "-b", "haas", "--motions")
        self.diff(part, "-m", tables, *sides, "--set-b", "IsoCoordinateTable.G54.X=7", status=0)
        self.diff(part, "-m", tables, *sides, "--set-b", "IsoCoordinateTable.G54.X=8")
        for option in ("-m", "--machine-a"):
            done = self.diff(part, option, "nowhere", "-a", "fanuc", "-b", "haas", status=2)
            self.assertIn("nowhere", done.stderr)

    def test_trouble(self):
        part = self.write("part.nc", PECKS)
        self.assertIn("[IG-0185]", self.diff("-d", "fanuc", part, status=2).stderr)
        self.assertIn("[IG-0510]", self.diff("-a", "fanuc", "-b", "syntec", "nowhere.nc", status=2).stderr)
        self.diff("-a", "fanuc", "-b", "nowhere", part, status=2)
        done = self.diff("-a", "fanuc", "-b", "syntec", "--set-b", "SyntecParameterTable.17=9", part, status=2)
        self.assertIn("[IG-0188]", done.stderr)
        self.diff("-d", "fanuc", "--set-b", "Nowhere.1=2", part, status=2)
        self.diff("-d", "fanuc", "--set-b", "Nowhere.1=2", "--motions", part, status=2)
        self.assertIn("[IG-0513]", self.diff("-d", "fanuc", "-", "-", status=2, input="").stderr)
        self.assertIn("[IG-0513]", self.diff("-d", "fanuc", "--against", part, part, part, status=2).stderr)

    def test_broken_programs_have_an_end(self):
        for name, text in (("empty", ""), ("loop", "G0 X1.\nN1 GOTO 1\n"), ("bytes", "\x01\x02G1 X\nO\n%\n" * 50),
                           ("calls", "M98 P1\nM99\nO1\nM98 P1\nM99\n"), ("half", "G1 X1.\nG83 X")):
            part = self.write(f"{name}.nc", text)
            for more in ([], ["--motions"]):
                done = self.diff("-a", "fanuc", "-b", "siemens", "--max-jumps", "1000", part, *more, status=None)
                self.assertIn(done.returncode, (0, 1), done.stderr)
                self.diff("-a", "fanuc", "-b", "fanuc", "--max-jumps", "1000", part, *more, status=0)

    def test_a_loop_of_errors_ends(self):
        part = self.write("loop.nc", "N1 G0 X1. Y!\nGOTO 1\n")
        for more in ([], ["--motions"]):
            done = self.diff("-a", "fanuc", "-b", "fanuc", "--max-errors", "100", part, *more, status=0)
            self.assertIn("[IG-0517]", done.stderr)

    def test_two_machines(self):
        for name, origin in (("one", "10"), ("two", "30")):
            self.write(f"{name}/machine.xml", f'<Machine xmlns="urn:isogloss:dialect:1" name="{name}" dialect="fanuc">'
                       '<Dependencies><IsoCoordinateTable><Offset id="G54" '
                       f'X="{origin}"/></IsoCoordinateTable></Dependencies></Machine>')
        part = self.write("part.nc", HEAD + "M30\n")
        causes, whole = self.causes("--machine-a", "one", "--machine-b", "two", part)
        self.assertEqual((whole["A"]["Name"], whole["B"]["Name"]), ("one", "two"))
        self.assertIn("IsoCoordinateTable G54", causes[0]["Cause"])
        self.assertIn("machine.xml:1", causes[0]["Evidence"][0]["PlaceB"])

    def test_a_block_with_many_reports_is_compared_in_good_time(self):
        if OPTIONS.sanitized:
            self.skipTest("slow there, whatever is compared")
        part = self.write("part.nc", HEAD + "\0" * 300_000 + "\nM30\n")
        said = self.diff("-a", "fanuc", "-b", "syntec", part, status=0).stderr
        self.assertIn("both sides report the same errors (count: 300000)", said)
        other = self.write("other.nc", HEAD + "\0" * 300_001 + "\nM30\n")
        lines = self.diff("-d", "fanuc", part, other).stdout.splitlines()
        self.assertLess(max(map(len, lines)), 5000)

    def test_of_a_long_line_the_part_that_differs_is_shown(self):
        comment = "(" + "\u00e4" * 500 + ")"
        one, other = (self.write(f"{x}.nc", f"{HEAD}{comment}G1 X{x}. F100. ({'B' * 600})\nM30\n") for x in (1, 2))
        shown = self.diff("-d", "fanuc", "--all", one, other).stdout
        for x in (1, 2):
            self.assertIn(f"\u00e4)G1 X{x}. F100. (BBB", shown)
        self.assertNotIn("\ufffd", shown)
        self.assertLess(max(map(len, shown.splitlines())), 600)

    def test_memory_does_not_grow_with_the_program(self):
        if OPTIONS.sanitized:
            self.skipTest("AddressSanitizer keeps what is freed")

        def peak(lines, *more):
            part = self.write(f"{lines}.nc", mill(lines))
            pid = os.fork()
            if pid == 0:
                os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
                os.execv(OPTIONS.isogloss, [OPTIONS.isogloss, "diff", *more, str(part)])
            _, status, usage = os.wait4(pid, 0)
            self.assertEqual(os.waitstatus_to_exitcode(status), 1)
            return usage.ru_maxrss
        few, many = (peak(n, "-d", "fanuc", "--set-b", "IsoCoordinateTable.G54.X=1") for n in (5_000, 40_000))
        self.assertLess(many, few * 1.1 + 4000, "KiB; every block differs")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True)
    parser.add_argument("--sanitized", action="store_true")
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.isogloss = str(pathlib.Path(OPTIONS.isogloss).resolve())
    unittest.main(argv=[sys.argv[0], *rest])
