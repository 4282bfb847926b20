#!/usr/bin/env python3
"""The checked-in schemas are those that the command prints, and they accept and refuse what the readers do."""
import argparse
import json
import os
import pathlib
import shutil
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
FILES = {"dialect": "dialect.xsd", "tables": "tables.xsd", "block": "block.schema.json"}

ROOT = '<Dialect xmlns="urn:isogloss:dialect:1" name="x"{0}>{1}</Dialect>'
MACHINE = '<Machine xmlns="urn:isogloss:dialect:1" name="x" dialect="fanuc">{}</Machine>'
REFUSED = {
    "unknown element": ROOT.format("", "<Chian/>"),
    "unknown attribute": ROOT.format(' colour="red"', ""),
    "missing name": '<Dialect xmlns="urn:isogloss:dialect:1"/>',
    "other namespace": '<Dialect name="x"/>',
    "unknown syntax": ROOT.format("", "<Chain><Logic><DrilingCycleSyntax/></Logic></Chain>"),
    "unknown option": ROOT.format("", '<Chain><Logic><DwellSyntax unit="s"/></Logic></Chain>'),
    "wrong choice": ROOT.format("", '<Chain><Logic><DwellSyntax p-unit="hours"/></Logic></Chain>'),
    "stages out of order": ROOT.format("", "<Chain><Logic/><Parsing/></Chain>"),
    "stage twice": ROOT.format("", "<Chain><Logic/><Logic/></Chain>"),
    "edit among stages": ROOT.format("", '<Chain><Logic/><Remove syntax="DwellSyntax"/></Chain>'),
    "empty replacement": ROOT.format(' extends="iso"', '<Chain><Replace syntax="DwellSyntax"/></Chain>'),
    "edit without anchor": ROOT.format(' extends="iso"', "<Chain><Remove/></Chain>"),
    "unknown dependency": ROOT.format("", "<Dependencies><OffsetTable/></Dependencies>"),
    "unknown row": ROOT.format("", "<Dependencies><ToolOffsetTable><Tol id='1'/></ToolOffsetTable></Dependencies>"),
    "row without key": ROOT.format("", "<Dependencies><ToolOffsetTable><Tool H='1'/></ToolOffsetTable></Dependencies>"),
    "number": ROOT.format("", "<Dependencies><ToolOffsetTable><Tool id='1' H='x'/></ToolOffsetTable></Dependencies>"),
    "Configure of a misspelt syntax": ROOT.format("", '<Chain><Configure syntax="DwelSyntax" p-unit="s"/></Chain>'),
    "Configure without a syntax": ROOT.format("", '<Chain><Configure p-unit="s"/></Chain>'),
    "Configure of an unknown option": ROOT.format("", '<Chain><Configure syntax="DwellSyntax" unit="s"/></Chain>'),
    "Configure with a wrong choice": ROOT.format("", '<Chain><Configure syntax="DwellSyntax" p-unit="hours"/></Chain>'),
    "Configure with a number that is none": ROOT.format(
        "", '<Chain><Configure syntax="CannedCycleResolveSyntax" max-repeats="many"/></Chain>'),
    "Configure with a number out of range": ROOT.format(
        "", '<Chain><Configure syntax="CannedCycleResolveSyntax" max-repeats="-1"/></Chain>'),
    "Configure with override": ROOT.format("", '<Chain><Configure syntax="DwellSyntax" override="yes"/></Chain>'),
    "anchor of Remove": ROOT.format("", '<Chain><Remove syntax="DwelSyntax"/></Chain>'),
    "anchor of InsertAfter": ROOT.format("", '<Chain><InsertAfter syntax="X"><DwellSyntax/></InsertAfter></Chain>'),
    "Configure of a misspelt dependency": ROOT.format(
        "", '<Dependencies><Configure dependency="IsoCordinateTable" additional-sets="1"/></Dependencies>'),
    "Configure of a dependency with a wrong value": ROOT.format(
        "", '<Dependencies><Configure dependency="IsoCoordinateTable" additional-sets="x"/></Dependencies>'),
    "plugin": ROOT.format("", '<Plugins><Plugin name="isso"/></Plugins>'),
    "importer": ROOT.format("", '<Dependencies><ToolOffsetTable src="a" format="TolTable"/></Dependencies>'),
    "option of an importer": MACHINE.format('<Backup src="backup" unit="feet"/>'),
    "importer of a backup": MACHINE.format('<Backup src="backup" format="Nothing"/>'),
    "severity of no code": ROOT.format("", '<Severities><Severity code="dwell" is="note"/></Severities>'),
    "severity": ROOT.format("", '<Severities><Severity code="IG-0212" is="fatal"/></Severities>'),
    "text": ROOT.format("", "<Chain>DwellSyntax</Chain>"),
}
ACCEPTED = {
    "empty": ROOT.format("", ""),
    "everything": ROOT.format(' extends="iso" title="t"', """
        <Files extensions=".nc .tap"><Signature pattern="^%"/></Files><Segmenter type="line"/>
        <Plugins><Plugin name="iso"/></Plugins>
        <Dependencies><ToolOffsetTable as="mine"><Tool id="1" H="-12.5"/></ToolOffsetTable>
          <Replace dependency="FallbackConfig"><FallbackConfig/></Replace><Remove dependency="MachineAxes"/>
          <Configure dependency="IsoCoordinateTable" additional-sets="100"/></Dependencies>
        <Initial><Field path="Unit.Term" value="G20"/></Initial>
        <Severities><Severity code="IG-0212" is="warning"/></Severities>
        <Chain><Replace syntax="DwellSyntax"><DwellSyntax as="again" p-unit="ms"/><McXyzSyntax as="b"/></Replace>
          <InsertAfter syntax="again"><PlaneSelectSyntax as="c" override="true"/></InsertAfter>
          <Configure syntax="again" p-unit="s"/><Remove syntax="b"/></Chain>"""),
    "backup": MACHINE.format('<Backup src="backup" unit="inch"/>'),
    # What XSD 1.0 cannot say: `isogloss lint` refuses it.
    "option of another syntax": ROOT.format(
        ' extends="iso"', '<Chain><Configure syntax="DwellSyntax" max-repeats="3"/></Chain>'),
}
TABLES_REFUSED = {
    "a column": '<ToolOffsetTable><Tool id="1" HH="2"/></ToolOffsetTable>',
    "a number": '<Dependencies><ToolOffsetTable><Tool id="1" H="x"/></ToolOffsetTable></Dependencies>',
    "a table": "<Dependencies><ToolOfsetTable/></Dependencies>",
    "an edit": '<Dependencies><Remove dependency="MachineAxes"/></Dependencies>',
    "a dialect": '<Dialect name="x"/>',
}


def printed(what):
    environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")}
    return subprocess.run([OPTIONS.isogloss, "schema", what], capture_output=True, text=True, check=True,
                          env=environment).stdout


class Schemas(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)

    def test_the_checked_in_files_are_current(self):
        for what, name in FILES.items():
            with self.subTest(name):
                self.assertEqual((OPTIONS.source / "schemas" / name).read_text(), printed(what),
                                 "it is not what the plugins declare now: ./dev regenerate")

    def accepts(self, file, schema="dialect.xsd"):
        done = subprocess.run(["xmllint", "--noout", "--nonet", "--schema", OPTIONS.source / "schemas" / schema,
                               file], capture_output=True, text=True, check=False)
        self.assertIn(done.returncode, (0, 3), done.stderr)
        return done.returncode == 0, done.stderr

    @unittest.skipUnless(shutil.which("xmllint"), "no xmllint")
    def test_files_are_valid_as_they_are_shipped(self):
        counts = {"dialect.xsd": 0, "tables.xsd": 0}
        for folder in ("dialects", "tests/programs", "tests/machines", "tests/bench"):
            for file in sorted((OPTIONS.source / folder).rglob("*.xml")):
                with self.subTest(str(file)):
                    schema = "dialect.xsd" if 'xmlns="urn:isogloss:dialect:1"' in file.read_text() else "tables.xsd"
                    counts[schema] += 1
                    accepted, why = self.accepts(file, schema)
                    self.assertTrue(accepted, why)
        self.assertGreater(min(counts.values()), 8, counts)

    @unittest.skipUnless(shutil.which("xmllint"), "no xmllint")
    def test_tables_without_a_namespace(self):
        file = self.path / "x.xml"
        for wanted, examples in ((True, {"rows": '<ToolOffsetTable><Tool id="1" H="2"/></ToolOffsetTable>'}),
                                 (False, TABLES_REFUSED)):
            for what, text in examples.items():
                with self.subTest(what):
                    file.write_text(text)
                    accepted, why = self.accepts(file, "tables.xsd")
                    self.assertEqual(accepted, wanted, why)

    @unittest.skipUnless(shutil.which("xmllint"), "no xmllint")
    def test_lint_says_what_the_schema_cannot(self):
        file = self.path / "x.xml"
        file.write_text(ACCEPTED["option of another syntax"])
        done = subprocess.run([OPTIONS.isogloss, "lint", file], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("DwellSyntax has no option 'max-repeats' [IG-0204]", done.stderr)

    @unittest.skipUnless(shutil.which("xmllint"), "no xmllint")
    def test_effective_dialects_are_valid(self):
        for name in ("iso", "fanuc"):
            file = self.path / f"{name}.xml"
            file.write_text(subprocess.run([OPTIONS.isogloss, "dialect", "--effective", name, "--inline"],
                                           capture_output=True, text=True, check=True).stdout)
            accepted, why = self.accepts(file)
            self.assertTrue(accepted, why)

    @unittest.skipUnless(shutil.which("xmllint"), "no xmllint")
    def test_what_is_accepted_and_refused(self):
        file = self.path / "x.xml"
        for wanted, examples in ((True, ACCEPTED), (False, REFUSED)):
            for what, text in examples.items():
                with self.subTest(what):
                    file.write_text(text)
                    accepted, why = self.accepts(file)
                    self.assertEqual(accepted, wanted, why)

    @unittest.skipUnless(jsonschema, "no jsonschema")
    def test_blocks_are_valid(self):
        schema = json.loads((OPTIONS.source / "schemas/block.schema.json").read_text())
        jsonschema.Draft202012Validator.check_schema(schema)
        validator = jsonschema.Draft202012Validator(schema)
        blocks = 0
        for program in golden_files(".nc"):
            with self.subTest(program.name):
                done = subprocess.run([OPTIONS.isogloss, "run", program, "-d", dialect_of(program), "--emit", "blocks"],
                                      capture_output=True, text=True, check=False)
                for line in done.stdout.splitlines():
                    validator.validate(json.loads(line))
                    blocks += 1
        self.assertGreater(blocks, 100)
        with self.assertRaises(jsonschema.ValidationError):
            validator.validate({"Feedrate": {"FeedrateValue": "fast"}})
        with self.assertRaises(jsonschema.ValidationError):
            validator.validate({"Feedrate": {"FeedrateValu": 1}})


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True)
    parser.add_argument("--source", required=True, type=pathlib.Path)
    parser.add_argument("--write", action="store_true", help="renew schemas/ and do not test")
    OPTIONS, rest = parser.parse_known_args()
    if OPTIONS.write:
        for kind, file_name in FILES.items():
            (OPTIONS.source / "schemas" / file_name).write_text(printed(kind))
        sys.exit(0)
    unittest.main(argv=[sys.argv[0], *rest])
