#!/usr/bin/env python3
"""The example machines in dialects/machines: they are found by name, lint finds nothing but parts of their backups that
are not read, and a sample program for each goes to the places that a person computes from the files.

  examples_test.py --isogloss PATH
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

OPTIONS = None
HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
# Of each machine: what its tables come from, and what lint names as not read.
EXAMPLES = {
    "klartext-5axis": ({"ToolOffsetTable": {"TOOL.T", "machine.xml"}, "IsoCoordinateTable": {"PRESET.PR"},
                        "HeidenhainDatums": {"VICES.D"}, "HeidenhainSystemData": {"machine.xml"}, "MachineAxes": {"axes.xml"}, "MachineKinematics": {"axes.xml"}},
                       {"column DOC", "column SHOP_RACK", "column SHOP_CHECKED", "column TL", "column RT", "column LOCKED", "tool 0"}),
    "siemens-mill": ({"ToolOffsetTable": {"TO1_TOA.INI"}, "SiemensCoordinateTable": {"CH1_UFR.INI"},
                      "SiemensVariables": {"UGUD.DEF", "CH1_GUD.INI"}, "SiemensMacros": {"MMAC.DEF"},
                      "MachineAxes": {"machine.xml"}},
                     {"tool management data", "magazine data"}),
    "fanuc-mill": ({"ToolOffsetTable": {"TOOLOFST.TXT"}, "IsoCoordinateTable": {"EXT_WKZ.TXT"},
                    "MacroVariables": {"MACRO.TXT"}, "FanucParameterTable": {"CNC-PARA.TXT", "fanuc.parameters.xml"}},
                   {"parameter", "name of a variable"}),
}


class Examples(unittest.TestCase):
    def start(self, *arguments, **more):
        with tempfile.TemporaryDirectory() as empty:  # neither the user's machines nor files of the current folder
            environment = {k: v for k, v in os.environ.items() if not k.startswith(("ISOGLOSS_", "XDG_"))}
            return subprocess.run([OPTIONS.isogloss, *map(str, arguments), "--diagnostics", "json", "--repeats", "0"],
                                  capture_output=True, text=True, timeout=60, check=False, cwd=empty,
                                  env=environment | {"HOME": empty}, **more)

    def command(self, *arguments):
        """The standard output of a command that finds neither errors nor warnings, and its notes."""
        done = self.start(*arguments)
        self.assertEqual(done.returncode, 0, f"{arguments}\n{done.stdout}\n{done.stderr}")
        notes = [json.loads(line) for line in done.stderr.splitlines()]
        self.assertEqual([n for n in notes if n["Severity"] != "note"], [], arguments)
        return done.stdout, notes

    def places(self, program, machine, wanted_notes=()):
        """Where each move ends, in machine coordinates: {(file, line): [place of the first pass, of the second, …]}."""
        out = {}
        motions, notes = self.command("run", HERE / program, "-m", machine, "--exact")
        self.assertEqual([n["Code"] for n in notes], list(wanted_notes))
        for event in map(json.loads, motions.splitlines()):
            at = event.get("MachineCoordinate")
            if at is not None:
                out.setdefault((pathlib.Path(event["File"]).name, event["Line"]), []).append(at)
        return out

    def assert_at(self, place, **wanted):
        for axis, value in wanted.items():
            self.assertAlmostEqual(place[axis], value, 3, f"{axis} of {place}, expected {wanted}")

    def test_machines_are_listed(self):
        listed = {m["Name"]: m for m in json.loads(self.command("list", "machines", "--json")[0])}
        for name, dialect in (("klartext-5axis", "heidenhain"), ("siemens-mill", "siemens"), ("fanuc-mill", "fanuc")):
            self.assertEqual(listed[name]["Dialect"], dialect)

    def test_inspect_names_the_tables_and_their_files(self):
        for name, (tables, _) in EXAMPLES.items():
            told = json.loads(self.command("inspect", name, "--json")[0])
            files = {}
            for source in told["Tables"]:
                files.setdefault(source["Table"], set()).add(pathlib.Path(source["File"]).name)
            for table, wanted in tables.items():
                self.assertEqual(files[table], wanted, f"{name}: {table}")
            self.assertEqual([pathlib.Path(p).parts[-2:] for p in told["Programs"]], [(name, "programs")])

    def test_inspect_shows_names_and_positions_of_axes(self):
        axes = {name: {row["Axis"]: row for row in json.loads(self.command("inspect", name, "--json")[0])["Axes"]}
                for name in EXAMPLES}
        self.assertEqual({a: row["Names"] for a, row in axes["siemens-mill"].items()}, {"X": "X1", "Y": "Y1", "Z": "Z1"})
        self.assertEqual(axes["siemens-mill"]["X"]["FixedPoint2"], "-350")
        self.assertEqual(axes["klartext-5axis"]["Z"]["Datum"], "420")
        self.assertEqual(axes["fanuc-mill"], {})  # parameters of the control hold its positions

    def test_lint_names_what_is_not_read(self):
        for name, (_, wanted) in EXAMPLES.items():
            notes = self.command("lint", "-m", name)[1]
            unread = {n["Message"].split(" is not read")[0] for n in notes if n["Code"] == "IG-0125"}
            self.assertEqual(wanted - unread, set(), f"{name}: {unread}")

    def test_klartext_5axis(self):
        # Tools 7 and 12 are sisters: both are named CHAMFER_D8.
        at, main = self.places("klartext-5axis.H", "klartext-5axis", ["HEI-0368"]), "klartext-5axis.H"
        # Preset 1 lies at X12.5 Y-20 Z-70. MILL_D12 is tool 2 of TOOL.T: L 98.6 with DL -0.03 makes 98.57.
        # Block 4: X = 12.5 + 30, Y = -20 + 10, and Z rests at its home 420. Z5: -70 + 5 + 98.57 = 33.57.
        self.assert_at(at[main, 6][0], X=42.5, Y=-10, Z=420, A=0, C=0)
        self.assert_at(at[main, 7][0], X=42.5, Y=-10, Z=33.57)
        self.assert_at(at[main, 8][0], Z=26.57)
        # RETRACT.H of the folder programs: Z0 from the builder's datum of Z (M92), which lies at 420.
        self.assert_at(at["RETRACT.H", 3][0], X=42.5, Y=-10, Z=420)
        # SPA-30 inclines the plane to the back: A-30, C0. Table A turns the part by +30 degrees about the line Y0.02 Z-80.
        # The preset lies (Y-20.02, Z10) from that line; turned: Y = -20.02 cos 30 - 10 sin 30 = -17.3378 - 5 = -22.3378,
        # Z = -20.02 sin 30 + 10 cos 30 = -10.01 + 8.6603 = -1.3497. In the machine: Y-22.3178, Z-81.3497. The plane is
        # level now, so words are added as they stand: Y15 is -7.3178, Z2 is -81.3497 + 2 + 98.57 = 19.2203.
        self.assert_at(at[main, 10][0], A=-30, C=0)
        self.assert_at(at[main, 11][0], X=12.5, Y=-7.3178, Z=420)
        self.assert_at(at[main, 12][0], X=12.5, Y=-7.3178, Z=19.2203)
        self.assert_at(at[main, 13][0], Z=13.2203)
        self.assert_at(at["RETRACT.H", 4][0], Z=420, A=0, C=0)
        # Row 3.1 of TOOL.T, the step of the drill: L 117.5. X = 12.5 - 20; Z2: -70 + 2 + 117.5.
        self.assert_at(at[main, 17][0], X=-7.5, Y=-20, Z=49.5)
        # Tool 7 by its name in TOOL.T, with the length 112.25 of machine.xml. Z10: -70 + 10 + 112.25.
        self.assert_at(at[main, 20][0], Z=52.25)
        # M192 of the builder does nothing, cycle 392 sets the smoothing; cycle 393 calls RETRACT.H. Z3: -70 + 3 + 112.25.
        self.assert_at(at[main, 25][0], Z=45.25)
        self.assert_at(at["RETRACT.H", 3][-1], Z=420)
        self.assertEqual(len(at["RETRACT.H", 3]), 5)
        # Row 2 of VICES.D on top of preset 1: X = 12.5 + 120 + 10, Y = -20 + 12.5, and C counts from 90.
        self.assert_at(at[main, 33][0], X=142.5, Y=-7.5, Z=420, C=90)

    def test_siemens_mill(self):
        at, main = self.places("siemens-mill.mpf", "siemens-mill"), "siemens-mill.mpf"
        # G54 is coarse and fine: X = -412.4 + 0.015 = -412.385, Y-236.75, Z = -438.2 - 0.03 = -438.23.
        # MILL_D16 is tool 4: 104.38 and wear -0.02 make 104.36. CLEAR_Z is 65 in CH1_GUD.INI; the definition says 80.
        self.assert_at(at[main, 4][0], X=-392.385, Y=-226.75, Z=0)
        self.assert_at(at[main, 5][0], Z=-438.23 + 65 + 104.36)  # -268.87
        # Z = -3 + STOCK[2] = -2.85: -438.23 - 2.85 + 104.36.
        self.assert_at(at[main, 6][0], Z=-336.72)
        # CORNERS(60,40) of the folder programs goes round and comes back.
        self.assert_at(at["CORNERS.SPF", 3][0], X=-332.385, Y=-226.75, Z=-336.72)
        self.assert_at(at["CORNERS.SPF", 4][0], X=-332.385, Y=-186.75)
        self.assert_at(at["CORNERS.SPF", 6][0], X=-392.385, Y=-226.75)
        # T_SLOT_D32: its lower edge D1 is 118.25 long, D2 = 104.25 + 0.5 (adapter) = 104.75.
        # Z65: -438.23 + 65 + 118.25 = -254.98. Z-6 with D2: -438.23 - 6 + 104.75 = -339.48.
        self.assert_at(at[main, 12][0], X=-437.385, Y=-226.75, Z=-254.98)
        self.assert_at(at[main, 13][0], Z=-339.48)
        # PARK.SPF: Z1 is Z by its name in machine.xml, and D0 leaves no tool length. Fixed point 2 is X-350 Y0.
        self.assert_at(at["PARK.SPF", 4][0], Z=0)
        self.assert_at(at["PARK.SPF", 5][0], X=-350, Y=0, Z=0)

    def test_siemens_mill_keeps_its_user_data(self):
        # LAST_PART is a STRING[20], PALLETS_DONE an INT that PARK.SPF counts up from 214; STOCK goes from 0 to 2.
        with tempfile.TemporaryDirectory() as folder:
            saved = pathlib.Path(folder) / "variables.xml"
            self.command("run", HERE / "siemens-mill.mpf", "-m", "siemens-mill", "--emit", "none",
                         "--save-table", f"SiemensVariables={saved}")
            rows = {row.get("name"): row.attrib for row in xml.etree.ElementTree.parse(saved).getroot()}
        self.assertEqual(rows["LAST_PART"]["Text"], "PAD AND SLOT")
        self.assertEqual(rows["PALLETS_DONE"]["Value"], "215")
        self.assertEqual((rows["STOCK[0]"]["Value"], rows["STOCK[2]"]["Value"]), ("0.2", "0.1"))
        for text, code in (("STOCK[2]=2.5", "SIE-0360"), ('LAST_PART="A NAME OF 21 LETTERS."', "SIE-0361"),
                           ("LAST_PART=5", "SIE-0130"), ("STOCK[3]=1", "SIE-0304")):
            told = self.start("run", "-", "-m", "siemens-mill", "--emit", "none", input=text + "\nM30\n").stderr
            self.assertEqual([json.loads(line)["Code"] for line in told.splitlines()], [code], text)

    def test_explain_shows_the_macro(self):
        program = ROOT / "dialects/machines/siemens-mill/programs/PARK.SPF:4"
        shown = self.command("explain", program, "-m", "siemens-mill")[0]
        self.assertIn('SiemensMacro.Name = "RETRACT_Z"', shown)

    def test_fanuc_mill(self):
        at, main = self.places("fanuc-mill.nc", "fanuc-mill"), "fanuc-mill.nc"
        # G54 is Y-210.1 Z-330.5, and the external offset adds Z-5. H2 is 131.62 with wear -0.04: 131.58.
        # Z50: -330.5 - 5 + 50 + 131.58 = -153.92.
        self.assert_at(at[main, 5][0], X=0, Y=0, Z=-153.92)
        # Parameter 6050 is 120: G120 calls O9010 as G65 does. Three holes, 25 apart, from X20 Y15; the R plane is #500 =
        # 3.5 (400C000000000000). R: -335.5 + 3.5 + 131.58 = -200.42. Z-12: -335.5 - 12 + 131.58 = -215.92.
        holes = at["O9010.nc", 5]
        bottoms = [p for p in holes if p["Z"] < -210]
        self.assertEqual(len(bottoms), 3)
        for place, x in zip(bottoms, (-375.25, -350.25, -325.25)):
            self.assert_at(place, X=x, Y=-195.1, Z=-215.92)
        self.assert_at(holes[-1], X=-325.25, Z=-200.42)
        # G54.1 P1 is Y-88.4 Z-301. Z1: -301 - 5 + 1 + 131.58.
        self.assert_at(at[main, 10][0], X=-612.75, Y=-88.4, Z=-173.42)
        # Parameter 6071 is 60: M60 calls O9001, whose Y is #501 = -60.
        self.assert_at(at["O9001.nc", 4][0], X=-380, Y=-60, Z=0)

    def test_limits_of_the_machine_are_checked(self):
        for machine, text in (("klartext-5axis", "0 BEGIN PGM A MM\n1 L X+301 R0 FMAX M91\n2 END PGM A MM\n"),
                              ("siemens-mill", "G0 SUPA Y0.5\nM30\n"), ("fanuc-mill", "G21G90G53G0Z-481.\nM30\n")):
            told = self.start("run", "-", "-m", machine, "--emit", "none", input=text).stderr
            self.assertEqual([json.loads(line)["Code"] for line in told.splitlines()], ["ISO-0403"], machine)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.isogloss = OPTIONS.isogloss.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
