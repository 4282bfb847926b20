#!/usr/bin/env python3
"""`--scan-ahead`: a run whose lines another thread has scanned gives what it gives alone.

  scan_ahead_test.py --isogloss PATH
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import budgeted  # noqa: E402: it lies in another folder

OPTIONS = None

# Lines that need nothing but their text. Where too few of a program are so, the thread ends.
PLAIN, PLAIN_KLARTEXT = "X1.5 Y2.\nX3. Z4.\nG1 X5. F300.\nM8\n" * 4, "L X+1.5 Y+2\nL X+3 F300\nL Z+4 R0\n" * 6
# A unit of each language: words and codes, comments, numbers of blocks, expressions, calls, what is wrong and what waits
# for its turn. {n} is the number of the unit.
ISO = """\
N{n} G0 X{n}.5 Y2
G1 X1.2345 Y-2.5 Z-.5 F500
g2 x3 y4 i1.5 j.25
(A COMMENT) G1 X2 (ANOTHER)
/G1 X3
X1X2
G1 X
N10 M8
M09 G90 G54
G1 Y1. Q3
Z1e5
G17 G40 G80
G83 X10 Y10 Z-10 R2 Q3 F100
X20
G80
"""
MACRO = """\
#1=#1+{n}
X#1 Y[#1*2]
X#4114 Y#4113
IF[#1GT1000]GOTO{n}1
X1.
N{n}1 G1 X2
M98 P2
#2=0
WHILE[#2LT3]DO1
#2=#2+1
X#2
END1
G10 L2 P1 X{n}
G65 P2 A1
M77 P1
"""
SIEMENS = """\
N{n} G0 X{n}.5 Y2
G1 X1.2345 Y-2.5 Z-.5 F500 ; a comment
R1=R1+1
X=R1 Y=AC(5)
IF R1>1000 GOTOF L{n}
X1
L{n}: X2
G2 X3 Y4 CR=5
X X1X2
"""
# Ends of a program in which words have another meaning than their text, which only a run knows that has come here.
SIEMENS_ENDS = {"of a curve": "CTABDEF(X,Y,1,0)\n" + "X5 Y5\nX6 Y6\n" * 200 + "CTABEND\nX7\nM30\n",
                "with another name": "DEFINE M8 AS X5 Y6\n" + "M8\nX1 Y2\nF100\n" * 200 + "M30\n"}
KLARTEXT = """\
{n} L X+{n}.5 Y+2 FMAX M8
L X+1.2345 Y-2.5 R0 F500 ; a comment
Q1 = Q1 + 1
L X+Q1
CC X+1 Y+1
C X+2 Y+3 DR+
L X
RND R1
L IX+1 IY-1 M3 M91
L X+Q1 FQ1
LBL {n}
CYCL DEF 7.0 DATUM
CYCL DEF 7.1 X+1
CYCL DEF 200 DRILLING
Q200=2
Q201=-5
Q206=100
L X+3 M99
PLANE SPATIAL SPA+0 SPB+0 SPC+0 STAY
FN 0: Q2 = +{n}
/L X+5
L Z+Q2
"""


def program(dialect, units, end):
    unit = {"siemens": SIEMENS, "heidenhain": KLARTEXT}.get(dialect, ISO if dialect in ("iso", "mazak") else ISO + MACRO)
    head = ""
    if dialect == "heidenhain":
        head, end = "0 BEGIN PGM A MM\nTOOL CALL 1 Z S1000\n", "99 END PGM A MM\n"
    elif dialect == "siemens":
        end = SIEMENS_ENDS[end]
    else:
        head, end = "%\nO1\nG21 G17 G90 G94\nT1 M6\nS1000 M3\n#1=0\n", "M30\nO2\nG91 X1\nG90\nM99\n%\n"
    # The last lines run again, from the beginning of the text: the thread has to find the place again.
    plain = PLAIN_KLARTEXT if dialect == "heidenhain" else PLAIN
    return head + "".join(unit.replace("{n}", str(n)) + plain for n in range(1, units + 1)) + end


class ScanAhead(unittest.TestCase):
    def run_it(self, *arguments):
        done = subprocess.run([OPTIONS.isogloss, *map(str, arguments)], capture_output=True, timeout=600)
        return done.returncode, done.stdout, done.stderr

    def test_the_result_is_the_same(self):
        units = max(300, int(budgeted(1500)))
        with tempfile.TemporaryDirectory() as folder:
            others = [(dialect, "") for dialect in ("iso", "fanuc", "haas", "syntec", "okuma", "heidenhain")]
            for dialect, end in (*others, *(("siemens", end) for end in SIEMENS_ENDS)):
                with self.subTest(dialect, end=end):
                    path = pathlib.Path(folder, "part.nc")
                    path.write_text(program(dialect, units, end))
                    run = ("run", path, "-d", dialect, "--emit", "motions", "--format", "csv")
                    alone = self.run_it(*run, "--scan-ahead", 0)
                    self.assertIn(alone[0], (0, 1), alone[2][-500:])
                    self.assertGreater(alone[1].count(b"\n"), 3 * units)
                    for lines in (1, 500):
                        self.assertEqual(self.run_it(*run, "--scan-ahead", lines), alone)

    def test_scanners_of_plain_words_may_be_asked_ahead(self):
        """One that is asked at each word and may not be would leave each line of its dialects to the run, unnoticed."""
        status, out, said = self.run_it("list", "syntaxes", "--json")
        self.assertEqual(status, 0, said)
        # This one is asked last, for what no other has read, and its lines are reported in their turn.
        asked = [s for s in json.loads(out) if set("XYZ") <= set(s.get("Scans", "")) and s["Id"] != "KlartextUnknownSyntax"]
        self.assertIn("WordSyntax", [s["Id"] for s in asked])
        self.assertEqual([s["Id"] for s in asked if not s.get("ScansAhead")], [])

    @unittest.skipIf(len(os.sched_getaffinity(0)) < 2, "one processor: the run scans by itself")
    def test_another_thread_scans(self):
        """A run that waits for the reader of its output has one thread more than without scanning ahead."""
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "part.nc")
            path.write_text("G90 G1 F100\n" + "".join(f"X{i % 977}.{i % 89:03} Y{i % 31}.125 Z{i % 7}\n" for i in range(100_000)))
            self.assertEqual(self.threads(path, 1), self.threads(path, 0) + 1)

    def threads(self, path, lines):
        """How many a run has when it has written more than its pipe holds."""
        command = [OPTIONS.isogloss, "run", path, "-d", "fanuc", "--emit", "motions", "--format", "csv", "--scan-ahead", lines]
        with subprocess.Popen([*map(str, command)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as run:
            try:
                run.stdout.read(1024)
                return len(os.listdir(f"/proc/{run.pid}/task"))
            finally:
                run.kill()

    def test_bad_values_are_refused(self):
        for value in ("-1", "many"):
            status, _, said = self.run_it("run", "-", "-d", "iso", "--scan-ahead", value)
            self.assertEqual(status, 2)
            self.assertIn(b"--scan-ahead", said)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True)
    OPTIONS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
