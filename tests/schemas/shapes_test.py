#!/usr/bin/env python3
"""What the commands write as JSON has the shape that schemas/ documents, and the motions have its keys and columns."""
import argparse
import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import jsonschema
except ImportError:
    jsonschema = None

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from golden_programs import dialect_of, golden_files  # noqa: E402: it lies in another folder

OPTIONS = None
DIALECT = '<Dialect xmlns="urn:isogloss:dialect:1" name="x" extends="iso">{}</Dialect>'


def command(*arguments, status=None):
    environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")}
    done = subprocess.run([OPTIONS.isogloss, *map(str, arguments)], capture_output=True, text=True, check=False,
                          env=environment, cwd=OPTIONS.source)
    if status is not None and done.returncode != status:
        raise AssertionError(f"{arguments}: {done.returncode}\n{done.stdout}{done.stderr}")
    return done


def schema(name):
    return json.loads((OPTIONS.source / "schemas" / f"{name}.schema.json").read_text())


@unittest.skipUnless(jsonschema, "no jsonschema")
class Shapes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)

    def validator(self, name, part=None):
        whole = schema(name)
        jsonschema.Draft202012Validator.check_schema(whole)
        if part is not None:
            whole = {**whole["$defs"][part], "$defs": whole["$defs"]}
        return jsonschema.Draft202012Validator(whole)

    def holds(self, name, *arguments, part=None):
        with self.subTest(" ".join(map(str, arguments))):
            value = json.loads(command(*arguments).stdout)
            for validator in (self.validator(name), self.validator(name, part)):
                errors = [f"{list(e.absolute_path)}: {e.message}"[:400] for e in validator.iter_errors(value)]
                self.assertEqual(errors, [])
            return value

    def refuses(self, name, value, part=None):
        self.assertFalse(self.validator(name, part).is_valid(value), value)

    def test_the_command_prints_the_files(self):
        for file in sorted((OPTIONS.source / "schemas").glob("*.schema.json")):
            name = file.name.removesuffix(".schema.json")
            if name == "block":
                continue  # made from the plugins: schemas_test.py
            with self.subTest(name):
                self.assertEqual(command("schema", name, status=0).stdout, file.read_text())
                self.assertEqual(schema(name)["$id"], f"urn:isogloss:schema:{name}:1")
        self.assertIn("did you mean 'motion'?", command("schema", "motoin", status=2).stderr)

    def test_lists(self):
        for what in ("plugins", "dialects", "machines", "importers", "syntaxes", "dependencies", "fields",
                     "diagnostics"):
            rows = self.holds("list", "list", what, "--json", part=what.capitalize())
            self.refuses("list", [{**rows[0], "Colour": "red"}], what.capitalize())
            self.refuses("list", [{}], what.capitalize())
        for dialect in ("fanuc", "siemens", "heidenhain"):
            self.holds("list", "list", "codes", "-d", dialect, "--json", part="Codes")
        self.holds("list", "list", "--json", part="Overview")

    def test_declarations(self):
        for name in ("DwellSyntax", "WordSyntax", "RadiusCompensationPathSyntax", "LinearMotionSyntax"):
            self.holds("inspect", "inspect", name, "--json", part="Syntax")
            self.holds("inspect", "inspect", name, "-d", "fanuc", "--json", part="Syntax")
        for name in ("ToolOffsetTable", "MachineAxes", "IsoCoordinateTable"):
            self.holds("inspect", "inspect", name, "-d", "fanuc", "--json", part="Dependency")
        self.holds("inspect", "inspect", "HeidenhainToolTable", "--json", part="Importer")
        for name in ("iso", "heidenhain"):
            self.holds("inspect", "inspect", name, "--json", part="Dialect")
        for name in ("fanuc-mill", "siemens-mill", "klartext-5axis"):
            self.holds("inspect", "inspect", name, "--json", part="Machine")
        self.holds("inspect", "inspect", "fanuc-mill", "--for", "tests/machines/fanuc-mill.nc", "--json",
                   part="Machine")
        self.holds("inspect", "inspect", "Feedrate.Term", "--json", part="Field")
        self.holds("inspect", "inspect", "G83", "-d", "fanuc", "--json", part="Code")
        self.holds("inspect", "inspect", "DwellSyntax", "--section", "Diagnostics", "--json", part="Section")

    def test_chains(self):
        for name in ("fanuc", "siemens"):
            self.holds("chain", "dialect", name, "--graph", "--json", part="Graph")
            self.holds("chain", "dialect", name, "--diff", "iso", "--json", part="Difference")
        for dialect, syntax in (("syntec", "DwellSyntax"), ("syntec", "SyntecCodeSyntax"), ("iso", "FeedrateSyntax")):
            self.holds("chain", "dialect", dialect, "--why", syntax, "--json", part="Why")

    def test_doctor(self):
        found = self.holds("doctor", "doctor", "--json")
        self.assertTrue(found["Plugins"])
        self.refuses("doctor", {**found, "Host": 1})

    def test_state(self):
        program = OPTIONS.source / "tests/programs/fanuc/demo.nc"
        found = self.holds("state", "state", f"{program}:20", "-d", "fanuc", "--json")
        self.assertTrue(found["State"])
        self.holds("state", "state", f"{program}:20", "-d", "fanuc", "--after", "--json")
        variables = self.path / "v.nc"
        variables.write_text("#101=2.5\n#102=#0\nG21\n")
        found = self.holds("state", "state", f"{variables}:3", "-d", "fanuc", "--json")
        self.assertIn(("#101", 2.5), [(v["Variable"], v["Value"]) for v in found["Variables"]])
        self.refuses("state", {**found, "When": "never"})

    def test_lint_tells_each_dialect_and_its_diagnostics(self):
        wrong = self.path / "x.xml"
        wrong.write_text(DIALECT.format('<Chain><Configure syntax="DwellSyntax" p-unit="hours"/></Chain>'))
        found = self.holds("lint", "lint", "fanuc", wrong, "--json")
        fanuc, mine = found["Checked"]
        self.assertEqual((fanuc["Name"], fanuc["Starts"], mine["Starts"]), ("fanuc", True, False))
        self.assertTrue(any(r["Others"] for r in fanuc["Rivals"]))
        fault = [d for d in mine["Diagnostics"] if d["Severity"] == "error"]
        self.assertEqual([(d["Code"], d["File"], d["Line"]) for d in fault], [("IG-0205", str(wrong), 1)])
        self.assertEqual(command("lint", "fanuc", wrong, "--json").returncode, 1)
        text = command("lint", "fanuc").stdout
        self.assertIn(f"fanuc: {fanuc['Syntaxes']} syntaxes, {fanuc['Dependencies']} dependencies", text)
        self.assertIn("Suggestion", self.holds("lint", "lint", "iso", "--suggest", "--json")["Checked"][0])
        self.refuses("lint", {"Isogloss": 2, "Checked": []})

    def test_import_and_export(self):
        table = self.path / "tools.tbl"
        table.write_text("T1 P1 Z+10.5 D6 ;mill\nT2 P2 Z+20 D8\n")
        found = self.holds("import", "import", table, "--json")
        [tools] = found["Tables"]
        self.assertEqual((tools["Table"], tools["Rows"][1]["Line"]), ("ToolOffsetTable", 2))
        self.assertNotIn("Output", found)
        found = self.holds("import", "import", table, "-o", self.path / "t.xml", "--json")
        self.assertIn("<ToolOffsetTable", pathlib.Path(found["Output"]).read_text())
        self.refuses("import", {**found, "Isogloss": 2})
        machine = "klartext-5axis"
        found = self.holds("export", "export", "-m", machine, "--format", "HeidenhainToolTable", "--json")
        text = command("export", "-m", machine, "--format", "HeidenhainToolTable", status=0).stdout
        self.assertEqual(found["Text"], text)
        found = self.holds("export", "export", "-m", machine, "--format", "HeidenhainToolTable", "--json", "-o",
                           self.path / "TOOL.T")
        self.assertEqual((self.path / "TOOL.T").read_text(), text)
        self.assertNotIn("Text", found)
        self.refuses("export", {**found, "LeftOut": [{}]})

    def test_new(self):
        for words in (("plugin", "acme"), ("dialect", "mine", "--extends", "siemens"), ("machine", "m1", "-d", "fanuc")):
            found = self.holds("new", "new", *words, "--in", self.path, "--json")
            self.assertEqual((found["What"], found["Name"]), words[:2])
            self.assertTrue(found["Files"])
            for file in found["Files"]:
                self.assertTrue(pathlib.Path(file).is_file(), file)
        self.refuses("new", {**found, "What": "car"})

    def test_docs(self):
        found = self.holds("docs", "docs", "-o", self.path / "reference", "--format", "markdown", "--json")
        self.assertEqual((found["Format"], found["First"]), ("markdown", "index.md"))
        for file in found["Files"]:
            self.assertTrue((self.path / "reference" / file).is_file(), file)
        self.refuses("docs", {**found, "Format": "pdf"})

    def test_manual(self):
        every = self.holds("manual", "manual", "--json")
        one = self.holds("manual", "manual", "motions", "--json")
        self.assertIn(one["Commands"][0], every["Commands"])
        formats, = [o for o in one["Commands"][0]["Options"] if "--format" in o["Names"]]
        self.assertEqual((formats["Words"], formats["Default"]), (["csv", "jsonl", "text"], "csv"))
        self.refuses("manual", {"Isogloss": 1, "Commands": [{"Name": "run"}]})
        self.assertIn("[IG-0513]", command("manual", "--json", "-o", self.path / "man", status=2).stderr)

    def test_cases(self):
        page = self.path / "dwell_syntax.md"
        page.write_text("# DwellSyntax\n\nText.\n\n## Wrong\n\n#BeforeBuild:\n```json\n{}\n```\n"
                        '#AfterBuild:\n```json\n{ "Dwell": { "Time": 1 } }\n```\n')
        found = self.holds("case", "case", page, "plugins/iso/motion/dwell_syntax.md", "--json")
        self.assertEqual((found["Failed"], found["Pages"][0]["Cases"][0]["Holds"]), (1, False))
        self.assertGreater(found["Held"], 2)
        self.assertIn("Dwell", found["Pages"][0]["Cases"][0]["Difference"])

    def test_checks_of_plugins(self):
        plugin = pathlib.Path(OPTIONS.isogloss).parent / "plugins" / "syntec.so"
        text = self.path / "notes.so"
        text.write_text("no library\n")
        found = self.holds("validate", "validate", plugin, text, "--only", "loads", "--only", "random-blocks", "--blocks",
                           10, "--json", part="Results")
        results = [[check["Result"] for check in one["Checks"]] for one in found["Plugins"]]
        self.assertEqual(results, [["held", "held"], ["failed", "skipped", "skipped"]])
        self.holds("validate", "validate", "--list", "--json", part="List")
        self.refuses("validate", {**found, "Plugins": [{"File": "a.so"}]})

    def test_diagnostics(self):
        program = self.path / "a.nc"
        program.write_text("G0 X1 Q5\nG81 X\n")
        lines = command("run", program, "-d", "fanuc", "--diagnostics", "json").stderr.splitlines()
        self.assertTrue(lines)
        for line in lines:
            self.validator("diagnostic").validate(json.loads(line))
        self.refuses("diagnostic", {"Severity": "fatal", "Code": "X-1", "Message": "m"})

    def test_summaries(self):
        validator = self.validator("summary")
        programs = golden_files(".nc")[:40]
        for program in programs:
            with self.subTest(program.name):
                arguments = ("run", program, "-d", dialect_of(program), "--summary")
                text = command(*arguments, "--json").stdout
                found = json.loads(text)
                validator.validate(found)
                self.assertEqual(text.count("\n"), 1)
                plain = dict(line.split(":", 1) for line in command(*arguments).stdout.splitlines())
                self.assertEqual(found["Blocks"], int(plain["blocks"]))
                self.assertTrue(plain["events"].strip().startswith(f"{found['Events']} "))
                self.assertEqual(found["RapidTime_s"] is None, "unknown" in plain["rapid time"])
        both = command("run", programs[0], programs[1], "-d", "fanuc", "--summary", "--json").stdout
        self.assertEqual([json.loads(line)["Program"] for line in both.splitlines()], [str(p) for p in programs[:2]])
        done = command("run", programs[0], "--json", "--format", "csv", status=2)
        self.assertIn("contradict", done.stderr)

    def test_results_of_a_batch(self):
        (self.path / "good.nc").write_text("G21 G90\nG1 X1. F100.\nM30\n")
        (self.path / "bad.nc").write_text("G999\nM30\n")
        (self.path / "loop.nc").write_text("N1 G0 X1.\nX0\nGOTO 1\n")
        command("batch", self.path, "-d", "fanuc", "-o", self.path / "out", "--max-time", "2", "--max-jumps", "999999999",
                "--max-loop-blocks", "99999999999", status=1)
        lines = (self.path / "out/results.jsonl").read_text().splitlines()
        self.assertEqual([json.loads(line)["Status"] for line in lines], ["errors", "ok", "out of time"])
        for line in lines:
            self.validator("batch").validate(json.loads(line))
        self.refuses("batch", {"Isogloss": 1, "Program": "a.nc", "Status": "good"})

    def test_motions_in_both_forms(self):
        whole, row = schema("motion"), self.validator("motion", "CsvRow")
        lines, columns = self.validator("motion"), list(whole["$defs"]["CsvRow"]["properties"])
        by_event = {d["properties"]["Event"]["const"]: list(d["properties"]) for d in whole["$defs"].values()
                    if "Event" in d["properties"]}
        events = set()
        programs = golden_files(".nc") + golden_files(".mpf") + golden_files(".h")
        for program in programs[::3]:
            with self.subTest(program.name):
                arguments = ("run", program, "-d", dialect_of(program))
                motions = [json.loads(line) for line in command(*arguments, "--header").stdout.splitlines()]
                for motion in motions:
                    lines.validate(motion)
                    if "Event" in motion:
                        order = [key for key in by_event[motion["Event"]] if key in motion]
                        self.assertEqual(list(motion), order, "keys stand in the order of the schema")
                        events.add(motion["Event"])
                table = list(csv.reader(command(*arguments, "--format", "csv").stdout.splitlines()))
                self.assertEqual(table[0], columns)
                self.assertEqual(len(table), len(motions))
                for cells, motion in zip(table[1:], motions[1:]):
                    record = {name: self.cell(name, text) for name, text in zip(columns, cells, strict=True)}
                    row.validate(record)
                    self.assertEqual((record["line"], record["event"]), (motion["Line"], motion["Event"]))
                    self.assertEqual(record["feed_mm_s"], motion.get("Feedrate_mmds"))
        self.assertGreaterEqual(len(events), 8, events)
        self.refuses("motion", {"File": "a", "Line": 0, "Event": "dwell", "Time": 1})
        self.refuses("motion", {"File": "a", "Line": 1, "Event": "dwell"})
        self.refuses("motion", {"File": "a", "Line": 1, "Event": "jog"})

    @staticmethod
    def cell(name, text):
        if text == "":
            return None
        return text if name in ("file", "event", "plane", "term") else json.loads(text)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True)
    parser.add_argument("--source", required=True, type=pathlib.Path)
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.isogloss = str(pathlib.Path(OPTIONS.isogloss).resolve())
    unittest.main(argv=[sys.argv[0], *rest])
