#!/usr/bin/env python3
"""The binary motion stream: `isogloss run --format binary`, and `isogloss motions`, which reads it.

  motions_test.py --isogloss PATH [--every N]
"""
import argparse
import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

try:
    import jsonschema
except ImportError:  # the other tests do not need it
    jsonschema = None

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from golden_programs import PROGRAMS, arguments_of, dialect_of, golden_files  # noqa: E402: it lies in another folder

OPTIONS = None
HEADER, RECORD = 960, 120
SOURCE = pathlib.Path(__file__).resolve().parents[2]
PART = "O0001\nG21 G17 G90 G54 G94\nT1 M6\nM3 S1000\nG0 X0 Y0 Z5.\nG1 Z-1. F100\nG2 X10. Y0 I5. J0\nG4 P500\nM8\nM30\n"


def isogloss(*arguments, given=None, status=0, cwd=PROGRAMS):
    done = subprocess.run([OPTIONS.isogloss, *map(str, arguments)], input=given, capture_output=True, check=False,
                          cwd=cwd)
    if status is not None and done.returncode != status:
        raise AssertionError(f"{arguments}: {done.returncode}\n{done.stderr.decode(errors='replace')}")
    return done


class Motions(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.part = self.folder / "part.nc"
        self.part.write_text(PART)

    def binary(self, *more):
        return isogloss("run", self.part, "-d", "fanuc", "--format", "binary", *more).stdout

    def test_every_golden_program_converts_to_the_bytes_of_the_run(self):
        count = 0
        for motions in golden_files(".motions.csv")[::4 * OPTIONS.every]:
            program = next(p for p in motions.parent.glob(motions.name.removesuffix("motions.csv") + "*")
                           if not p.name.endswith((".args", ".diagnostics.txt", ".motions.csv", ".xml")))
            run = ["run", program.name, "-d", dialect_of(program), *arguments_of(program)]
            stream = isogloss(*run, "--format", "binary", status=None, cwd=program.parent).stdout
            for form in ("csv", "jsonl", "text"):
                direct = isogloss(*run, "--format", form, "--exact", status=None, cwd=program.parent).stdout
                read = isogloss("motions", "-", "--format", form, "--exact", given=stream).stdout
                self.assertEqual(read, direct, f"{program} as {form}")
            count += len(stream) > HEADER
        self.assertGreater(count, 20 / OPTIONS.every)

    def test_the_decimals_of_a_run_are_those_of_its_stream(self):
        direct = isogloss("run", self.part, "-d", "fanuc", "--format", "csv").stdout
        self.assertEqual(isogloss("motions", "-", given=self.binary()).stdout, direct)

    def test_several_programs_are_one_stream(self):
        other = self.folder / "other.nc"
        other.write_text(PART)
        run = ["run", self.part, other, self.part, "-d", "fanuc"]
        stream = isogloss(*run, "--format", "binary").stdout
        self.assertEqual(stream.count(b"IGMOTN"), 1)
        self.assertEqual(isogloss("motions", "-", given=stream).stdout, isogloss(*run, "--format", "csv").stdout)

    def test_header_and_records_are_as_documented(self):
        stream = self.binary()
        self.assertEqual(stream[:8], b"\x93IGMOTN\n")
        self.assertEqual(struct.unpack_from("<4I", stream, 8), (1, HEADER, RECORD, 0))
        self.assertEqual((len(stream) - HEADER) % RECORD, 0)
        header = json.loads(stream[24:HEADER])
        sizes = {"u1": 1, "<u2": 2, "<u4": 4, "<i8": 8, "<f8": 8}
        self.assertEqual(sum(sizes[f[1]] * (f[2] if len(f) > 2 else 1) for f in header["Fields"]), RECORD)
        if jsonschema:
            jsonschema.validate(header, json.loads((SOURCE / "schemas/motion-stream.schema.json").read_text()))
        records = [stream[at:at + RECORD] for at in range(HEADER, len(stream), RECORD)]
        events = [r for r in records if r[8] < 128]
        self.assertEqual([r[8] for r in events], [6, 4, 0, 1, 2, 3, 7, 9])
        arc = events[4]
        self.assertEqual(struct.unpack_from("<2d", arc, 16), (10, 0))
        self.assertAlmostEqual(struct.unpack_from("<d", arc, 96)[0], -180)
        self.assertAlmostEqual(struct.unpack_from("<d", arc, 112)[0], 3.14159265 * 5 / (100 / 60), 5)

    def test_damaged_streams_are_diagnostics(self):
        stream = self.binary()
        good = isogloss("motions", "-", given=stream).stdout
        for given, code in ((b"", b"IG-0640"), (PART.encode(), b"IG-0640"), (os.urandom(5000), b"IG-0640"),
                            (stream[:500], b"IG-0642"), (stream[:-1], b"IG-0642"),
                            (stream[:8] + b"\x09" + stream[9:], b"IG-0641"),
                            (stream[:-RECORD + 8] + b"\x63" + stream[-RECORD + 9:], b"IG-0643")):
            done = isogloss("motions", "-", given=given, status=1)
            self.assertIn(code, done.stderr)
            self.assertTrue(good.startswith(done.stdout))
        for at in range(0, len(stream), 13 * OPTIONS.every):
            flipped = stream[:at] + bytes([stream[at] ^ 0xff]) + stream[at + 1:]
            self.assertIn(isogloss("motions", "-", given=flipped, status=None).returncode, (0, 1))
            if at > 1500:
                break

    def test_a_damaged_stream_leaves_an_older_file(self):
        target = self.folder / "part.csv"
        target.write_text("older\n")
        isogloss("motions", "-", "-o", target, given=self.binary()[:-5], status=1)
        self.assertEqual(target.read_text(), "older\n")
        isogloss("motions", "-", "-o", target, given=self.binary())
        self.assertTrue(target.read_text().startswith("file,line,event"))

    def test_what_has_no_binary_form_is_refused(self):
        self.assertIn(b"blocks have no binary form",
                      isogloss("run", self.part, "--emit", "blocks", "--format", "binary", status=2).stderr)
        self.assertIn(b"IG-0513", isogloss("run", self.part, "--json", "--format", "binary", status=2).stderr)
        self.assertIn(b"IG-0510", isogloss("motions", self.folder / "none.igm", status=2).stderr)
        self.assertIn(b"IG-0510", isogloss("motions", self.folder, status=2).stderr)
        self.assertIn(b"IG-0530", isogloss("motions", self.part, "-o", self.part, status=2).stderr)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--every", type=int, default=1, help="of the programs and damages only each Nth")
    OPTIONS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
