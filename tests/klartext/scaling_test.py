#!/usr/bin/env python3
"""A program under cycle 11 against the same program with each length multiplied by the factor: the machine must move
alike, since the control scales positions, radii, increments and the dimensions of cycles, and neither tool nor feed.

  scaling_test.py --isogloss PATH
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

OPTIONS = argparse.Namespace()
# {…} are lengths in mm; what stands without braces is not scaled.
CONTOUR = """L X{-20} Y{-10} Z{50} FMAX
L Z{-5} F300
L IX{3} IY{4}
L IX{3} Y{-2}
CC X{0} Y{0}
L X{10} Y{0}
C X{0} Y{10} DR+
CR X{20} Y{10} R{12} DR-
CT X{30} Y{0}
LP PR{25} PA+45
CP PA+90 DR+
CP IPA+720 IZ{-4} DR+
L X{-40} Y{-40} Z{5} FMAX
"""
SIDES = """APPR LCT X{0} Y{-30} R{12} RL F200
L X{30}
RND R{8}
L Y{10}
RND R{1}
L X{40}
L Y{20}
CHF {3}
L X{0}
DEP LCT X{-60} Y{40} R{12}
L Z{40} FMAX
"""
HOLES = """CYCL DEF 200 Q200={2} Q201={-12} Q206=150 Q202={5} Q210=0 Q203={1} Q204={30} Q211=0
L X{5} Y{5} FMAX M99
CYCL CALL POS X{15} Y{5} Z{2} FMAX
CYCL DEF 203 Q200={2} Q201={-22} Q206=150 Q202={5} Q210=0 Q203={0} Q204={30} Q212={1} Q213=2 Q205={2} Q211=0 Q208=500 Q256={0.5}
L X{5} Y{15} FMAX M99
CYCL DEF 205 Q200={2} Q201={-22} Q206=150 Q202={5} Q203={0} Q204={30} Q212={1} Q205={2} Q258={0.5} Q259={0.7} Q257={8} Q256={0.5} Q211=0 Q379={0} Q253=750 Q208=500
L X{5} Y{25} FMAX M99
CYCL DEF 208 Q200={2} Q201={-8} Q206=150 Q334={2} Q203={0} Q204={30} Q335={30} Q342={20} Q351=1
L X{25} Y{25} FMAX M99
CYCL DEF 209 Q200={2} Q201={-10} Q239=1.25 Q203={0} Q204={30} Q257={4} Q256={0.5} Q336=0 Q403=1
L X{1} Y{2} FMAX M99
CYCL DEF 201 Q200={2} Q201={-10} Q206=100 Q211=0.5 Q208=250 Q203={0} Q204={30}
L X{3} Y{2} FMAX M99
CYCL DEF 207 Q200={2} Q201={-9} Q239=1.5 Q203={0} Q204={30}
L X{7} Y{2} FMAX M99
PATTERN DEF POS1 (X{25} Y{33} Z{0}) POS2 (X{50} Y{75} Z{-1})
CYCL CALL PAT FMAX
CYCL DEF 221 Q225={15} Q226={15} Q237={10} Q238={8} Q242=3 Q243=2 Q224=15 Q200={2} Q203={3} Q204={50} Q301=1
CYCL DEF 240 Q200={2} Q343=0 Q201={-3} Q344={0} Q206=100 Q211=0 Q203={0} Q204={30}
CYCL DEF 220 Q216={10} Q217={20} Q244={40} Q245=0 Q246=360 Q247=0 Q241=5 Q200={2} Q203={0} Q204={30} Q301=1 Q365=0
"""
SHIFT = "CYCL DEF 7.0\nCYCL DEF 7.1 X{7}\nCYCL DEF 7.2 Y{3}\nCYCL DEF 7.3 Z{2}\n"
AROUND = {
    "alone": ("", ""),
    "before it a shift": ("CYCL DEF 7.0\nCYCL DEF 7.1 X+7\nCYCL DEF 7.2 Y+3\n", ""),
    "behind it a shift": ("", SHIFT),
    "a rotation and a shift": ("", "CYCL DEF 10.0\nCYCL DEF 10.1 ROT+30\n" + SHIFT),
    "a tilted plane": ("", "PLANE SPATIAL SPA+20 SPB+10 SPC+5 STAY\n" + SHIFT),
}
FIVE_AXES = """L X{10} Y{20} Z{80} FMAX
PLANE SPATIAL SPA+0 SPB+20 SPC+10 TURN FMAX SEQ+
L X{0} Y{0} Z{20} F500
CC X{0} Y{0}
L X{3}
C X{-3} Y{0} DR+
PLANE RESET TURN F1000
L X{0} Y{0} Z{30} F500
L M128 F1000
L X{1} Y{2} Z{25} A+10 C+20 F500
L IX{3} A+5 C+40
L M140 MB 20
L X{0} Y{0} Z{10} A+0 C+0
L M129
L Z{12}
L M140 MB 20
L M140 MB MAX
"""


def program(body, factor, is_scaled):
    """The text with its lengths as they stand, under cycle 11, or multiplied by the factor."""
    pieces = body.replace("}", "{").split("{")
    lengths = [f"{float(p) * (1 if is_scaled else factor):+.9g}" for p in pieces[1::2]]
    return "".join(a + b for a, b in zip(pieces[::2], [*lengths, ""]))


class Scaled(unittest.TestCase):
    def motions(self, body, *options):
        lines = ["BEGIN PGM A MM", "TOOL CALL 1 Z S2000 F500", "L R0 FMAX M3", *body.splitlines(), "L M30", "END PGM A MM"]
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "a.h")
            path.write_text("".join(f"{n} {line}\n" for n, line in enumerate(lines)))
            done = subprocess.run([OPTIONS.isogloss, "run", path, "--exact", *options], capture_output=True, text=True,
                                  timeout=60, check=False)
        self.assertNotIn("[HEI-0161]", done.stderr)
        return [json.loads(line) for line in done.stdout.splitlines()], [
            line.partition(": ")[2] for line in done.stderr.splitlines()]

    def assert_alike(self, before, body, *options):
        for factor in (2.0, 0.5, 1.005):
            cycle = f"CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL {factor}\n"
            scaled, said = self.motions(before + cycle + program(body, factor, True), *options)
            plain, said_of_plain = self.motions(before + "; \n; \n" + program(body, factor, False), *options)
            self.assertEqual([m["Event"] for m in scaled], [m["Event"] for m in plain], (factor, said, said_of_plain))
            self.assertGreater(len(scaled), 10)
            self.assertEqual(said, said_of_plain)
            for a, b in zip(scaled, plain):
                self.assertEqual(a["Line"], b["Line"])
                self.assertEqual(a.get("Feedrate_mmds"), b.get("Feedrate_mmds"), (factor, a))
                there, wanted = a.get("MachineCoordinate", {}), b.get("MachineCoordinate", {})
                self.assertEqual(there.keys(), wanted.keys())
                for axis, position in there.items():
                    self.assertAlmostEqual(position, wanted[axis], 6, (factor, a, b))

    def test_contours_and_cycles(self):
        tool = ("-d", "heidenhain", "--set", "ToolOffsetTable.1.D=3", "--set", "ToolOffsetTable.1.H=57.5")
        for name, (before, behind) in AROUND.items():
            for body in (CONTOUR, SIDES, HOLES):
                with self.subTest(name, body=body[:9]):
                    self.assert_alike(before, behind + body, *tool)

    def test_the_plane_alone(self):
        """Nothing that is scaled along the tool axis: 2D contours, and levels as they stand."""
        with tempfile.TemporaryDirectory() as folder:
            dialect = pathlib.Path(folder, "plane.xml")
            dialect.write_text('<Dialect xmlns="urn:isogloss:dialect:1" name="plane" extends="heidenhain"><Chain>'
                               '<Configure syntax="KlartextFrameCycleSyntax" scaled-axes="plane"/></Chain></Dialect>')
            tool = ("-d", dialect, "--set", "ToolOffsetTable.1.D=3")
            flat = [re.sub(r"Z\{(\S+?)\}", r"Z\1", body) for body in (CONTOUR, SIDES)]
            for body in flat:
                self.assert_alike("", body + "L M140 MB 20\n", *tool)
            self.assert_alike("", "CYCL DEF 7.0\nCYCL DEF 7.1 X{7}\nCYCL DEF 7.3 Z2\n" + flat[0], *tool)
            upright = "CYCL DEF 11.1 SCL 0.5\nL X+10 Z+0 F300\nCC X+0 Z+0\nC X+0 Z+10 DR+\n"
            self.assertTrue(any("C is no circle" in line for line in self.motions(upright, *tool)[1]))

    def test_a_mirror_image(self):
        self.assert_alike("", "CYCL DEF 8.0\nCYCL DEF 8.1 X\n" + CONTOUR + HOLES, "-d", "heidenhain",
                          "--set", "ToolOffsetTable.1.D=3")

    def test_tilted_planes_and_tip_control(self):
        self.assert_alike("", FIVE_AXES, "-m", "klartext-5axis")

    def test_positions_of_the_machine(self):
        self.assert_alike("", "L X{3} Y{4} FMAX\nL Z+100 FMAX M91\nL X{5}\nL X+20 FMAX M91\nL Y{7}\n" * 3, "-d", "heidenhain")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", type=pathlib.Path, required=True)
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.isogloss = OPTIONS.isogloss.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
