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
FILES = {"dialect": "dialect.xsd", "block": "block.schema.json"}

ROOT = '<Dialect xmlns="urn:isogloss:dialect:1" name="x"{0}>{1}</Dialect>'
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
          <Configure dependency="IsoCoordinateTable" any="thing"/></Dependencies>
        <Initial><Field path="Unit.Term" value="G20"/></Initial>
        <Severities><Severity code="IG-0212" is="warning"/></Severities>
        <Chain><Replace syntax="DwellSyntax"><DwellSyntax as="again" p-unit="ms"/><McXyzSyntax as="b"/></Replace>
          <InsertAfter syntax="again"><PlaneSelectSyntax as="c" override="true"/></InsertAfter>
          <Configure syntax="again" p-unit="s"/><Remove syntax="b"/></Chain>"""),
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

    def accepts(self, file):
        done = subprocess.run(["xmllint", "--noout", "--nonet", "--schema", OPTIONS.source / "schemas/dialect.xsd",
                               file], capture_output=True, text=True, check=False)
        self.assertIn(done.returncode, (0, 3), done.stderr)
        return done.returncode == 0, done.stderr

    @unittest.skipUnless(shutil.which("xmllint"), "no xmllint")
    def test_dialects_are_valid(self):
        files = list((OPTIONS.source / "dialects").glob("*.xml"))
        self.assertGreaterEqual(len(files), 2)
        for file in files:
            with self.subTest(file.name):
                if "<Dialect " not in file.read_text():
                    continue  # a table without namespace; the dialect that names it is read by the tests of the reader
                accepted, why = self.accepts(file)
                self.assertTrue(accepted, why)

    @unittest.skipUnless(shutil.which("xmllint"), "no xmllint")
    def test_machines_are_valid(self):
        files = list((OPTIONS.source / "dialects" / "machines").rglob("*.xml"))
        self.assertGreaterEqual(len(files), 6)
        for file in files:
            with self.subTest(file.name):
                accepted, why = self.accepts(file)
                self.assertTrue(accepted, why)

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
