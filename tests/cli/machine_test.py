#!/usr/bin/env python3
"""Machines as users set them up: folders that commands find by name, files of controls, import, export and new.

  machine_test.py --isogloss PATH
"""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

OPTIONS = None

HEAD = '<Machine xmlns="urn:isogloss:dialect:1" name="mill" title="Mill in hall 2" dialect="fanuc">'
TOOLS = "T1 P1 Z98.2 D10 ;EM10\nT2 P2 Z80 D6\n"


class Machines(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def write(self, name, text):
        path = self.path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def machine(self, content, folder="machines/mill"):
        return self.write(f"{folder}/machine.xml", f"{HEAD}\n{content}\n</Machine>\n")

    def run_it(self, *arguments, status=0, **more):
        environment = {k: v for k, v in os.environ.items() if not k.startswith(("ISOGLOSS_", "XDG_"))}
        environment |= {"HOME": str(self.path / "home")} | more.pop("env", {})
        done = subprocess.run([OPTIONS.isogloss, *map(str, arguments)], capture_output=True, text=True, timeout=60,
                              check=False, cwd=self.path, env=environment, **more)
        self.assertEqual(done.returncode, status, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done

    def test_a_machine_brings_tables_and_programs(self):
        self.machine('<Dependencies><ToolOffsetTable src="tools.xml"/></Dependencies><Programs src="programs"/>')
        self.write("machines/mill/tools.xml", '<ToolOffsetTable><Tool id="1" H="100"/></ToolOffsetTable>')
        self.write("machines/mill/programs/O9001.nc", "O9001\nG0 Z20.\nM99\n")
        part = self.write("part.nc", "G21 G90 G54 G43 H1 Z10.\nM98 P9001\nM30\n")
        for named in (["-m", "mill", "--machines", "machines"], ["-m", "machines/mill"],
                      ["-m", "machines/mill/machine.xml"]):
            done = self.run_it("run", part, *named, "--emit", "motions", "--format", "csv")
            ends = [line.split(",")[8] for line in done.stdout.splitlines() if ",rapid," in line]
            self.assertEqual(ends, ["110", "120"], named)

    def siemens_machine(self, files, more="", programs="backup"):
        """A machine whose backup has these programs, and where the calls of a main program go: the X of their moves."""
        self.write("mill/machine.xml", '<Machine xmlns="urn:isogloss:dialect:1" name="mill" dialect="siemens">'
                   f'<Programs src="{programs}"/>{more}</Machine>')
        for name, text in files.items():
            self.write(f"mill/backup/{name}", text)

    def moves(self, main, text, status=0):
        program = self.write(main, text)
        done = self.run_it("run", program, "-m", "mill", "--emit", "motions", "--format", "csv", status=status)
        return [line.split(",")[3] for line in done.stdout.splitlines() if ",rapid," in line], done.stderr

    def test_programs_are_searched_in_the_folders_of_the_control(self):
        self.siemens_machine({"CUS.DIR/cycle_a.spf": "G0 X1\n", "cma.dir/CYCLE_A.SPF": "G0 X2\n",
                              "Cst.dir/_N_CYCLE_B_SPF": "%_N_CYCLE_B_SPF\n;$PATH=/_N_CST_DIR\nG0 X3\n",
                              "SPF.DIR/L123.SPF": "G0 X4\n", "WKS.DIR/X.WPD/SHAPE.SPF": "G0 X5\n",
                              "cma.dir/SHAPE.SPF": "G0 X7\n", "SPF.DIR/HOLE.SPF": "G0 X8\n",
                              "CUS.DIR/HOLE.SPF": "G0 X9\n", "MPF.DIR/NEAR.MPF": "G0 X10\n",
                              "CUS.DIR/NEAR.SPF": "G0 X11\n", "SPF.DIR/CYCLE71.SPF": "PROC CYCLE71(REAL A)\nG0 X=A\n"})
        main = "mill/backup/MPF.DIR/MAIN.MPF"
        for call, x in (("CYCLE_A", "1"), ("Cycle_B", "3"), ("L123", "4"), ("SHAPE", "7"), ("HOLE", "8"), ("NEAR", "10"),
                        ('CALLPATH("/_N_WKS_DIR/_N_X_WPD")\nSHAPE', "5"),
                        ('CALLPATH("/_N_WKS_DIR/_N_X_WPD")\nCALLPATH()\nSHAPE', "7"),
                        ('CALL "/_N_CUS_DIR/_N_HOLE_SPF"', "9"), ("PCALL HOLE", "8"),
                        ('EXTCALL("WKS.DIR/X.WPD/SHAPE.SPF")', "5"), ('EXTCALL("ELSEWHERE/HOLE.SPF")', "8"),
                        ("CYCLE71(71)", "71")):
            self.assertEqual(self.moves(main, call + "\nM30\n")[0], [x], call)
        # A main program in a workpiece finds what stands beside it.
        self.assertEqual(self.moves("mill/backup/WKS.DIR/X.WPD/MAIN.MPF", "SHAPE\nM30\n")[0], ["5"])
        notes = self.moves(main, "CYCLE_A\nCYCLE_A\nL123\nM30\n")[1]
        self.assertEqual(notes.count("IG-0135"), 1, notes)
        self.assertIn("cma.dir/CYCLE_A.SPF", notes)
        # No folder of a workpiece is searched without a path, and no other folder with one.
        error = self.moves(main, 'CALL "/_N_SPF_DIR/_N_CYCLE_A_SPF"\nM30\n', status=1)[1]
        self.assertIn("SIE-0165", error)

    def test_the_tree_of_a_backup_may_stand_one_folder_further_down(self):
        self.siemens_machine({"nc/CUS.DIR/CYCLE_A.SPF": "G0 X1\n", "nc/CMA.DIR/CYCLE_A.SPF": "G0 X2\n"})
        # Beside the main program, another machine's tree is none of its own.
        self.write("another/CUS.DIR/CYCLE_A.SPF", "G0 X9\n")
        found, notes = self.moves("part.mpf", "CYCLE_A\nM30\n")
        self.assertEqual(found, ["1"])
        self.assertNotIn("another", notes)
        order = '<SearchOrder><Folder name="CMA.DIR"/><ProgramPath/><Folder name="CUS.DIR"/></SearchOrder>'
        self.siemens_machine({}, order)
        self.assertEqual(self.moves("part.mpf", "CYCLE_A\nM30\n")[0], ["2"])
        for wrong in ("<Folder/>", '<Folder name="a/b"/>', "<Place/>", "<ProgramPath/><ProgramPath/>"):
            self.siemens_machine({}, f"<SearchOrder>{wrong}</SearchOrder>")
            self.run_it("lint", "-m", "mill", status=1)

    def test_a_file_of_several_programs_names_the_folder_of_each(self):
        archive = ("%_N_MAIN_MPF\n;$PATH=/_N_MPF_DIR\nHOLE\nCALL \"/_N_CMA_DIR/_N_HOLE_SPF\"\nNEAR\nM30\n"
                   "%_N_HOLE_SPF\n;$PATH=/_N_CMA_DIR\nG0 X1\nM17\n%_N_HOLE_SPF\n;$PATH=/_N_CUS_DIR\nG0 X2\nM17\n"
                   "%_N_NEAR_SPF\n;$PATH=/_N_CUS_DIR\nG0 X3\nM17\n%_N_NEAR_SPF\n;$PATH=/_N_MPF_DIR\nG0 X4\nM17\n")
        self.siemens_machine({"A.SPF": ""})
        self.assertEqual(self.moves("all.arc", archive)[0], ["2", "1", "4"])

    def test_explain_names_the_line_of_the_row_that_answered(self):
        self.machine('<Dependencies>\n<MachineCodes>\n<Code name="M92" does="nothing"/>\n<Code name="m2*" '
                     'does="nothing"/>\n</MachineCodes></Dependencies>')
        part = self.write("part.nc", "G0 X1. M92\nM215 P1\nM30\n")
        one = self.run_it("explain", f"{part}:1", "-m", "machines/mill").stdout
        self.assertRegex(one, r"row M92 of MachineCodes, \S*machine.xml:4")
        two = json.loads(self.run_it("explain", f"{part}:2", "-m", "machines/mill", "--json").stdout)
        rows = [row for block in two for step in block["Steps"] for row in step.get("Rows", [])]
        self.assertEqual([(r["Dependency"], r["Row"], r["Line"]) for r in rows], [("MachineCodes", "m2*", 5)])
        given = self.run_it("explain", f"{part}:2", "-m", "machines/mill", "--set", "MachineCodes.M215.does=nothing").stdout
        self.assertIn("row M215 of MachineCodes, given by --set", given)

    def rows_of(self, program, lines, dialect, tables):
        """{line: [(table, row, line in the XML)]} of what explain names."""
        part = self.write("rows.txt", program)
        given = self.write("rows.xml", f"<Dependencies>\n{tables}\n</Dependencies>")
        out = {}
        for line in lines:
            blocks = json.loads(self.run_it("explain", f"{part}:{line}", "-d", dialect, "--machine", given, "--json").stdout)
            found = [(row["Dependency"], row["Row"], row["Line"]) for block in blocks for step in block["Steps"]
                     for row in step.get("Rows", []) if row.get("File", "").endswith("rows.xml")]
            out[line] = list(dict.fromkeys(found))
        return out

    def test_explain_names_rows_of_every_table(self):
        rows = self.rows_of("#100=#500+#1005\nG54 G0 G43 H[#501] X#500\n#500=7\nX#500\nG30 P2 X0\n"
                            "G73 Z-5. R2. Q1. F100.\nM30\n", range(1, 7), "fanuc",
                            '<MacroVariables>\n<Variable number="500" Value="3"/><Variable number="501" Value="4"/>'
                            '<Variable number="1005" Value="1"/></MacroVariables>\n<FanucParameterTable>'
                            '<Parameter number="5114" Value="900"/><Parameter number="1241" X="-50"/></FanucParameterTable>\n'
                            '<IsoCoordinateTable><Offset id="G54" X="1"/></IsoCoordinateTable>\n'
                            '<ToolOffsetTable><Tool id="4" H="80"/></ToolOffsetTable>')
        variable = "MacroVariables"
        self.assertEqual(rows, {
            1: [(variable, "500", 3), (variable, "1005", 3)],
            2: [(variable, "501", 3), (variable, "500", 3), ("ToolOffsetTable", "4", 6), ("IsoCoordinateTable", "G54", 5)],
            3: [], 4: [], 5: [("FanucParameterTable", "1241", 4)], 6: [("FanucParameterTable", "5114", 4)]})
        rows = self.rows_of('R5=R7+1\nG54 G0 X=R7 Y=STOCK[0,1]\nIF $A_IN[3]==1 GOTOF A\nOPEN_DOOR\nA:\nT="MILL" D1 M6\nR7=4\n'
                            "X=R7\nG75 X0 FP=2\nM30\n", (1, 2, 3, 4, 6, 8, 9), "siemens",
                            '<SiemensVariables><Variable name="r7" Value="3"/><Variable name="STOCK" Size="2,2" Value="8"/>\n'
                            '<Variable name="$A_IN[3]" Value="0"/></SiemensVariables>\n<SiemensMacros>'
                            '<Macro name="Open_Door" Text="M24"/></SiemensMacros>\n<MachineCodes><Code name="M24" '
                            'does="nothing"/></MachineCodes>\n<MachineAxes><Axis name="X" FixedPoint2="-9"/></MachineAxes>\n'
                            '<SiemensCoordinateTable><Offset id="G54" X="1"/></SiemensCoordinateTable>\n'
                            '<ToolOffsetTable><Tool id="4" Name="MILL" H="80"/></ToolOffsetTable>')
        variable = "SiemensVariables"
        self.assertEqual(rows, {
            1: [(variable, "r7", 2)],
            2: [(variable, "r7", 2), (variable, "STOCK", 2), ("SiemensCoordinateTable", "G54", 7)],
            3: [(variable, "$A_IN[3]", 3)], 4: [("SiemensMacros", "Open_Door", 4), ("MachineCodes", "M24", 5)],
            6: [("ToolOffsetTable", "4", 8)], 8: [], 9: [("MachineAxes", "X", 6)]})
        rows = self.rows_of("0 BEGIN PGM A MM\n1 FN 18: SYSREAD Q1 = ID990 NR2 IDX0\n2 CYCL DEF 7.0\n3 CYCL DEF 7.1 #5\n"
                            '4 SEL PATTERN "HOLES.PNT"\n5 L X+Q5 R0 FMAX M92\n6 Q5 = 3\n7 L X+Q5 FMAX\n8 FN 19: PLC=+10\n'
                            "9 CYCL DEF 247 Q339=+2\n10 L Z+50 R0 FMAX\n11 END PGM A MM\n", (2, 4, 5, 6, 8, 9, 10), "heidenhain",
                            '<HeidenhainSystemData><Data id="ID990 NR2" Value="1"/></HeidenhainSystemData>\n'
                            '<HeidenhainDatums><Datum id="zero.d#5" X="7"/></HeidenhainDatums>\n<HeidenhainPoints>'
                            '<Point id="HOLES.PNT#1" X="1" Y="2"/></HeidenhainPoints>\n<QParameters><Q number="5" '
                            'Value="2"/></QParameters>\n<MachineAxes><Axis name="X" Datum="-10"/></MachineAxes>\n<MachineCodes>'
                            '<Code name="FN 19" does="nothing"/></MachineCodes>\n<IsoCoordinateTable><Offset '
                            'id="DATUM_PRESET_2" X="1"/></IsoCoordinateTable>\n<HeidenhainBasicRotations><Preset number="2" '
                            'SPC="1"/></HeidenhainBasicRotations>')
        self.assertEqual(rows, {
            2: [("HeidenhainSystemData", "ID990 NR2", 2)], 4: [("HeidenhainDatums", "zero.d#5", 3)],
            5: [("HeidenhainPoints", "HOLES.PNT#1", 4)], 6: [("QParameters", "5", 5), ("MachineAxes", "X", 6)], 8: [],
            9: [("MachineCodes", "FN 19", 7)],
            10: [("HeidenhainBasicRotations", "2", 9), ("IsoCoordinateTable", "DATUM_PRESET_2", 8)]})

    def test_explain_names_the_program_that_a_block_calls(self):
        self.machine('<Programs src="programs"/>')
        self.write("machines/mill/programs/O9001.nc", "%\nO9001\nG0 Z20.\nM99\n")
        part = self.write("part.nc", "G21 G90 G54\nM98 P9001\nM30\n")
        text = self.run_it("explain", f"{part}:2", "-m", "machines/mill").stdout
        self.assertRegex(text, r"calls O9001, \S*programs/O9001.nc:\d")
        block, = json.loads(self.run_it("explain", f"{part}:2", "-m", "machines/mill", "--json").stdout)
        self.assertTrue(block["Calls"]["File"].endswith("O9001.nc"))
        block, = json.loads(self.run_it("explain", f"{part}:1", "-m", "machines/mill", "--json").stdout)
        self.assertEqual(block["Calls"], {})

    def test_machines_are_found_in_four_places(self):
        part = self.write("part.nc", "G21 G90 G0 X1.\nM30\n")
        self.machine("", "there/mill")
        self.run_it("run", part, "-m", "mill", "--emit", "none", env={"ISOGLOSS_MACHINES": str(self.path / "there")})
        self.machine("", "home/.config/isogloss/machines/mill")
        self.run_it("run", part, "-m", "mill", "--emit", "none")
        self.machine("", "config/isogloss/machines/mill")
        self.run_it("run", part, "-m", "mill", "--emit", "none", env={"XDG_CONFIG_HOME": str(self.path / "config")})
        listed = self.run_it("list", "machines").stdout
        self.assertRegex(listed, r"mill +fanuc +Mill in hall 2")
        self.assertIn("ac-table", listed)
        done = self.run_it("run", part, "-m", "mil", "--emit", "none", status=2)
        self.assertIn("did you mean mill?", done.stderr)
        self.assertIn("[IG-0123]", done.stderr)
        done = self.run_it("run", part, "-m", "no/where", "--emit", "none", status=2)
        self.assertIn("[IG-0510]", done.stderr)

    def test_all_commands_that_take_a_dialect_take_a_machine(self):
        self.machine("")
        part = self.write("part.nc", "G21 G90 G0 X1.\nM30\n")
        here = ["-m", "mill", "--machines", "machines"]
        self.run_it("explain", f"{part}:1", *here)
        self.run_it("lint", *here)
        self.assertIn("G81", self.run_it("list", "codes", *here).stdout)
        self.assertIn('name="mill"', self.run_it("dialect", *here).stdout)
        self.run_it("inspect", "DwellSyntax", *here)
        told = json.loads(self.run_it("inspect", "mill", "--json", "--machines", "machines").stdout)
        self.assertEqual(told["Dialect"], ["fanuc", "iso"])
        lacks = {one["Service"]: one for one in told["Lacks"]}["isogloss.machine-kinematics/1"]
        self.assertEqual((lacks["Need"], lacks["Offered by"]), ("optional", ["MachineKinematics"]))
        self.assertIn("ToolCenterPointSyntax", lacks["Asked by"])
        well = json.loads(self.run_it("doctor", "--json", "--machines", "machines").stdout)
        self.assertIn("mill", [m["Name"] for m in well["Machines"]])
        done = self.run_it("run", part, "-d", "fanuc", *here, "--emit", "none", status=2)
        self.assertIn("leave out -d", done.stderr)

    def test_inspect_shows_which_needs_of_a_program_a_machine_answers(self):
        self.machine('<Backup src="tool.tbl"/><Programs src="programs"/>'
                     '<Dependencies><ToolOffsetTable unlisted="missing"/>'
                     '<MachineCodes><Code name="m92*" does="nothing"/></MachineCodes></Dependencies>')
        self.write("machines/mill/tool.tbl", TOOLS)
        self.write("machines/mill/programs/O9001.nc", "O9001\nG0 Z20.\nM99\n")
        part = self.write("part.nc", "G21 G90 G55 G0 G43 H1 Z10.\nG43 H7 Z5.\nM98 P9001\nM98 P9001\nM98 P77\nM925\nM30\n")
        done = self.run_it("inspect", "machines/mill", "--for", part, "--json", status=1)
        needs, = json.loads(done.stdout)["Needs"]
        rows = {(row["Table"], row["Row"]): row["Answers"] for row in needs["Rows"]}
        self.assertEqual(rows["ToolOffsetTable", "1"], "tool.tbl:1")
        self.assertTrue(rows["ToolOffsetTable", "7"].startswith("no row"))
        self.assertNotIn(("ToolOffsetTable", "2"), rows)
        self.assertEqual(rows["MachineCodes", "m92*"], "machine.xml:2")
        self.assertEqual(rows["IsoCoordinateTable", "G55"], "the table as it is delivered")
        self.assertEqual(needs["Programs called"], [{"Program": "O9001", "File": "programs/O9001.nc"}])
        codes = {one["Code"]: one["First"] for one in needs["Not answered"]}
        self.assertEqual(codes["ISO-0223"], f"{part}:2")
        self.assertTrue([place for place in codes.values() if place == f"{part}:5"])
        fit = self.write("fit.nc", "G21 G90 G0 G43 H1 Z10.\nM30\n")
        shown = self.run_it("inspect", "mill", "--machines", "machines", "--for", fit, "--for", fit).stdout
        self.assertEqual(shown.count("      ToolOffsetTable  Row 1  Answers tool.tbl:1\n"), 2)
        self.assertNotIn("Not answered", shown)
        done = self.run_it("inspect", "fanuc", "--for", fit, status=2)
        self.assertIn("--for needs a machine", done.stderr)

    def test_parts_of_a_machine_and_their_faults(self):
        self.write("machines/mill/axes.xml",
                   '<Machine xmlns="urn:isogloss:dialect:1"><Dependencies><MachineAxes><Axis name="X" Maximum="5"/>'
                   '</MachineAxes></Dependencies></Machine>')
        self.machine('<Include src="axes.xml"/>')
        part = self.write("part.nc", "G21 G90 G0 X9.\nM30\n")
        done = self.run_it("run", part, "-m", "machines/mill", "--emit", "none", status=1)
        self.assertIn("[ISO-0403]", done.stderr)
        self.write("machines/mill/axes.xml",
                   '<Machine xmlns="urn:isogloss:dialect:1"><Include src="machine.xml"/></Machine>')
        for content, code in (('<Include src="axes.xml"/>', "IG-0121"), ('<Programs src="cycels"/>', "IG-0122"),
                              ('<Include src="../axes.xml"/>', "IG-0117"), ("<Tools/>", "IG-0107"),
                              ('<Backup src="none.t"/>', "IG-0126"),
                              ('<Dependencies><ToolOffsetTable format="Csv"/></Dependencies>', "IG-0108")):
            self.machine(content)
            done = self.run_it("run", part, "-m", "machines/mill", "--emit", "none", status=2)
            self.assertIn(f"[{code}]", done.stderr, content)
            self.assertIn("machine", done.stderr.splitlines()[0])

    def test_files_of_a_control_are_read_as_they_are(self):
        self.write("machines/mill/backup/tool.tbl", TOOLS)
        part = self.write("part.nc", "G21 G90 G54 G43 H2 Z10.\nM30\n")
        for content in ('<Backup src="backup" unit="mm"/>',
                        '<Backup src="backup/tool.tbl" format="LinuxCncToolTable" unit="mm"/>',
                        '<Dependencies><ToolOffsetTable src="backup/tool.tbl" unit="mm"/></Dependencies>',
                        '<Dependencies><ToolOffsetTable src="backup/tool.tbl"/></Dependencies>'):
            self.machine(content)
            done = self.run_it("run", part, "-m", "machines/mill", "--emit", "motions", "--format", "csv")
            self.assertEqual([line.split(",")[8] for line in done.stdout.splitlines() if ",rapid," in line], ["90"])
            # The file does not name its unit.
            self.assertEqual("[TAB-0112]" in done.stderr, "unit=" not in content)
            self.assertLessEqual(done.stderr.count("\n"), 1)
        self.assertIn("word P is not read: no table has a place for it (count: 2) [IG-0125]",
                      self.run_it("lint", "-m", "machines/mill").stderr)
        # The machine's own row goes over that of the file, cell by cell.
        self.machine('<Backup src="backup"/><Dependencies><ToolOffsetTable><Tool id="2" HWear="0.5"/></ToolOffsetTable>'
                     "</Dependencies>")
        done = self.run_it("run", part, "-m", "machines/mill", "--emit", "motions", "--format", "csv")
        self.assertIn("90.5", done.stdout)
        self.write("machines/mill/backup/readme.txt", "Call Ann before you change anything.\n")
        for name in ("readme.1", "O1.nc", "O2.nc"):
            self.write(f"machines/mill/backup/{name}", "Call Ann before you change anything.\n")
        read = self.run_it("lint", "-m", "machines/mill").stderr
        self.assertIn("readme.txt is not read: no importer recognises it (files of this extension: 1) [IG-0132]", read)
        self.assertIn("O1.nc is not read: no importer recognises it (files of this extension: 2) [IG-0132]", read)
        self.machine('<Backup src="backup" unit="mm"/><Programs src="backup"/>')
        read = self.run_it("lint", "-m", "machines/mill").stderr
        self.assertIn("readme.1 is not read", read)
        self.assertNotIn("O1.nc", read)
        self.write("machines/mill/backup/old.tbl", "Call Ann before you change anything.\n")
        self.assertRegex(self.run_it("lint", "-m", "machines/mill").stderr,
                         r"warning: \S*old\.tbl is not read: its name is usual for LinuxCncToolTable.*\[IG-0142\]")
        self.machine('<Backup src="backup/readme.txt"/>')
        self.assertIn("[IG-0124]", self.run_it("lint", "-m", "machines/mill", status=1).stderr)
        self.machine('<Dependencies><MachineAxes src="backup/tool.tbl"/></Dependencies>')
        self.assertIn("[IG-0128]", self.run_it("lint", "-m", "machines/mill").stderr)

    def test_rows_of_one_table_may_stand_in_several_files(self):
        """Later ones go over earlier ones, in the order in which machine.xml names them."""
        self.write("machines/mill/a.xml", '<Dependencies><ToolOffsetTable size="50"><Tool id="1" H="100"/>'
                                          '<Tool id="2" H="20"/></ToolOffsetTable></Dependencies>')
        self.write("machines/mill/b.xml", '<ToolOffsetTable><Tool id="2" H="30"/></ToolOffsetTable>')
        self.machine('<Include src="a.xml"/><Dependencies><ToolOffsetTable><Tool id="1" HWear="1"/><Tool id="2" H="25"/>'
                     '</ToolOffsetTable></Dependencies><Include src="b.xml"/>')
        part = self.write("part.nc", "G21 G90 G54 G43 H1 Z0\nG43 H2 Z0\nM30\n")
        done = self.run_it("run", part, "-m", "machines/mill", "--emit", "motions", "--format", "csv")
        self.assertEqual([line.split(",")[8] for line in done.stdout.splitlines() if ",rapid," in line], ["101", "30"])
        self.write("machines/mill/b.xml", '<Dependencies><MachineAxes as="ToolOffsetTable"/></Dependencies>')
        self.assertIn("[IG-0113]", self.run_it("lint", "-m", "machines/mill", status=1).stderr)

    def test_no_output_replaces_what_is_read(self):
        table = self.write("machines/mill/backup/tool.tbl", TOOLS)
        self.machine('<Backup src="backup"/>')
        part = self.write("part.nc", "G21 G90 G0 X1.\nM30\n")
        here = ["-m", "machines/mill"]
        for command in (["run", part, *here, "-o", table], ["import", table, "-o", table],
                        ["export", *here, "--format", "CsvTools", "-o", table],
                        ["run", part, *here, "--diagnostics-output", table]):
            self.assertIn("[IG-0530]", self.run_it(*command, status=2).stderr)
        self.assertEqual(table.read_text(), TOOLS)

    def test_a_machine_reads_neither_pipes_nor_files_outside_its_folder(self):
        self.write("outside.tbl", TOOLS)
        (self.path / "machines/mill/backup").mkdir(parents=True)
        os.symlink(self.path / "outside.tbl", self.path / "machines/mill/backup/tool.tbl")
        self.machine('<Backup src="backup"/>')
        self.assertIn("[IG-0117]", self.run_it("lint", "-m", "machines/mill", status=1).stderr)
        os.remove(self.path / "machines/mill/backup/tool.tbl")
        os.mkfifo(self.path / "machines/mill/tool.tbl")
        for content in ('<Backup src="tool.tbl"/>', '<Dependencies><ToolOffsetTable src="tool.tbl"/></Dependencies>'):
            self.machine(content)
            self.run_it("lint", "-m", "machines/mill", status=1)

    def test_saved_values_go_over_the_initial_ones_of_definitions(self):
        """Whatever the files of a folder are called: definitions are read first."""
        self.write("card/A_GUD.INI", "%_N_CH1_GUD_INI\nCHANDATA(1)\nCLEAR_Z=65\nM17\n")
        self.write("card/UGUD.DEF", "%_N_UGUD_DEF\nDEF NCK REAL CLEAR_Z=80\nDEF NCK REAL OTHER_Z=7\nM17\n")
        tables = self.run_it("import", "card").stdout
        self.assertIn('<Variable name="CLEAR_Z" Value="65" Type="REAL" />', tables)
        self.assertIn('<Variable name="OTHER_Z" Value="7" Type="REAL" />', tables)
        self.assertIn("<!-- A_GUD.INI:3 -->", tables)

    def test_a_file_without_rows_is_reported(self):
        self.write("machines/mill/TOOL.T", "BEGIN TOOL.T MM\nT    NAME    L     R\n[END]\n")
        self.machine('<Backup src="TOOL.T"/>')
        self.assertIn("[IG-0134]", self.run_it("lint", "-m", "machines/mill").stderr)

    def test_tables_of_a_run_may_be_files_of_a_control(self):
        self.write("TOOLOFST.TXT", "%\nG10G90L10P1R112.4\n%\n")
        part = self.write("part.nc", "G21 G90 G54 G17 G94\nG43 H1 G0 Z50.\nM30\n")
        tools = self.write("tools.xml", '<Dependencies><ToolOffsetTable src="TOOLOFST.TXT" format="FanucOffsets"/></Dependencies>')
        for option in ("--tools", "-m"):
            done = self.run_it("run", part, "-d", "fanuc", option, tools, "--emit", "motions", "--format", "csv")
            self.assertIn(",162.4,", done.stdout)
        self.write("tools.xml", '<Dependencies><ToolOffsetTable src="nowhere.TXT" format="FanucOffsets"/></Dependencies>')
        self.run_it("run", part, "-d", "fanuc", "--tools", tools, status=2)

    def test_import_of_a_folder_without_files_keeps_what_was_written(self):
        (self.path / "empty").mkdir()
        kept = self.write("kept.xml", "<Dependencies/>\n<!-- mine -->\n")
        self.assertIn("[IG-0124]", self.run_it("import", "empty", "-o", kept, status=1).stderr)
        self.assertIn("mine", kept.read_text())

    def test_import_writes_tables_with_their_sources(self):
        table = self.write("tool.tbl", TOOLS)
        done = self.run_it("import", table)
        self.assertIn("<!-- tool.tbl:1 -->", done.stdout)
        self.assertIn('<Tool id="1" H="98.2" D="5" Name="EM10" />', done.stdout)
        self.assertIn("[IG-0125]", done.stderr)
        self.assertIn("2 rows of 1 table", done.stderr)
        self.run_it("import", table, "--set", "unit=inch", "-o", "machines/mill/")
        self.machine('<Include src="imported.xml"/>')
        part = self.write("part.nc", "G21 G90 G54 G43 H1 Z0\nM30\n")
        self.assertIn(",2494.28,", self.run_it("run", part, "-m", "machines/mill", "--emit", "motions", "--format",
                                               "csv").stdout)
        for arguments, code in (([table, "--format", "Csv"], "IG-0129"), ([table, "--set", "unit=foot"], "IG-0205")):
            self.assertIn(f"[{code}]", self.run_it("import", *arguments, status=1).stderr)
        for missing in (["nothing.tbl"], [table, "nothing.tbl", "-o", "kept.xml"]):
            self.assertIn("nothing.tbl: error: cannot be read", self.run_it("import", *missing, status=2).stderr)
        self.run_it("import", status=2)

    def test_the_content_of_a_file_tells_its_format(self):
        source = pathlib.Path(__file__).parents[2]
        pages = [(page, page.read_text()) for page in sorted((source / "plugins").rglob("*.md"))]
        examples = [(page, example) for page, text in pages
                    if (example := re.search(r"^#File: (\S+)\n+```\n(.*?)^```", text, re.S | re.M))
                    and not page.name.endswith(".cases.md")]
        self.assertGreaterEqual(len(examples), 13)
        for page, example in examples:
            name = "".join(part.capitalize() for part in page.stem.split("_"))
            file = self.write(f"{page.stem}/{example[1]}", example[2])
            known, named = self.run_it("import", file), self.run_it("import", file, "--format", name)
            self.assertEqual((known.stdout, known.stderr), (named.stdout, named.stderr), page)

    def test_no_program_is_taken_for_a_table(self):
        for name, program in {
                "calls": "%\nN0010 M98 P1000\nN0020 M5\nN0030 M30\n%\n", "speed": "N0010 S100 M3\nN0020 M5\n",
                "numbers": "%\nO1000\nN10\nN20\nM30\n%\n", "macro": "O9000\n#500=1\nM6\nM30\n",
                "tool": "T1 P1 M6\nG0 X1\n", "offset": "G10 L2 P1 X0\nG0 X1\nM30\n",
                "tool.t": "0 BEGIN PGM A MM\n1 L X+0\n", "local.mpf": "DEF REAL X=5\nR1=5\nG0 X1\nM30\n",
                "edge.mpf": "$TC_DP3[1,1]=5\nT1 D1\nG0 X0\nM30\n"}.items():
            self.write(f"programs/{name}", program)
        for folder in ("programs", pathlib.Path(__file__).parents[1] / "programs"):
            done = self.run_it("import", folder)
            self.assertIn("0 rows of 0 tables", done.stderr)
            self.assertEqual([line for line in done.stderr.splitlines() if "IG-0125" in line], [])

    def test_codes_of_a_serial_line_change_nothing(self):
        def rows(data):
            (self.path / "offsets.txt").write_bytes(data)
            done = self.run_it("import", "offsets.txt")
            return done.stdout, done.stderr

        plain = b"%\nG10L10P1R98.2\nG10L12P1R5.Y1.\n%\n"
        for data in (b"\0\0\x12" + plain + b"\x14\0\x1a", plain.replace(b"\n", b"\r\r\n"),
                     plain.replace(b"\n", b"\x13\x11\n\0\0")):
            self.assertEqual(rows(data), rows(plain))

    def test_new_machine_runs_from_a_backup(self):
        self.write("tool.tbl", TOOLS)
        done = self.run_it("new", "machine", "mill", "--dialect", "heidenhain", "--backup", "tool.tbl", "--in", "machines")
        self.assertEqual(done.stdout.strip(), "machines/mill/machine.xml")
        part = self.write("part.h", '0 BEGIN PGM A MM\n1 TOOL CALL "em10" Z S100\n2 L Z+5 R0 FMAX\n3 END PGM A MM\n')
        done = self.run_it("run", part, "-m", "mill", "--machines", "machines", "--emit", "motions", "--format", "csv")
        self.assertIn("103.2", done.stdout)
        self.run_it("lint", "-m", "mill", "--machines", "machines")
        done = self.run_it("new", "machine", "mill", "--dialect", "heidenhain", "--in", "machines", status=2)
        self.assertIn("there already", done.stderr)
        for name in ("a/b", ".", "..", "a\nb", ""):
            self.run_it("new", "machine", name, "--dialect", "heidenhain", status=2)
        self.run_it("new", "machine", "a--b <&>", "--dialect", "heidenhain", "--title", 'The "old" <one> & more -- here')
        self.run_it("lint", "-m", "a--b <&>")
        self.assertIn("[IG-0101]", self.run_it("new", "machine", "c", "--dialect", "heidenhein", status=2).stderr)
        self.run_it("new", "dialect", "c", "--dialect", "heidenhain", status=2)

    def test_options_of_a_folder_are_for_the_files_that_have_them(self):
        self.write("machines/mill/backup/tool.tbl", TOOLS)
        self.write("machines/mill/backup/mill.var", "5161\t0.0\n5221\t1.0\n5222\t0.0\n5223\t0.0\n")
        part = self.write("part.nc", "G21 G90 G54 G43 H1 Z0\nM30\n")
        self.machine('<Backup src="backup" unit="inch"/>')
        self.assertIn(",2494.28,", self.run_it("run", part, "-m", "machines/mill", "--emit", "motions", "--format",
                                               "csv").stdout)
        self.machine('<Backup src="backup" units="inch"/>')
        self.assertIn("has no option 'units' [IG-0204]",
                      self.run_it("lint", "-m", "machines/mill", status=1).stderr)
        self.write("machines/mill/backup/second.tbl", TOOLS)
        self.machine('<Backup src="backup" unit="cm"/>')
        done = self.run_it("lint", "-m", "machines/mill", status=1)
        self.assertIn("[IG-0205]", done.stderr)
        self.assertEqual(done.stderr.count("error:"), 1, done.stderr)

    def test_files_that_are_no_text_are_named_by_their_importers(self):
        archive = self.write("machines/mill/backup/cmm.arc", "")
        archive.write_bytes(b"@@MMCIBN.002" + bytes(20) + b";x")
        self.write("machines/mill/backup/CYCLE_OEM.CPF", "").write_bytes(b"\x8f\xa4\x01" + bytes(9) + b"\xfe")
        self.write("machines/mill/backup/picture.bmp", "").write_bytes(b"BM" + bytes(9))
        self.machine('<Backup src="backup"/>')
        read = self.run_it("lint", "-m", "machines/mill").stderr
        self.assertRegex(read, r"cmm\.arc is not read: this is a binary archive.*\[IG-0141\]")
        self.assertRegex(read, r"CYCLE_OEM\.CPF is not read: this cycle is encrypted.*\[IG-0141\]")
        self.assertRegex(read, r"picture\.bmp is not read: no importer.*\[IG-0132\]")
        self.machine('<Backup src="backup/cmm.arc"/>')
        self.assertIn("[SIE-0353]", self.run_it("lint", "-m", "machines/mill", status=1).stderr)

    def test_options_beside_src_are_those_of_the_table_and_of_its_importer(self):
        self.write("machines/mill/tool.tbl", "T1 P1 Z2 D.5\n")
        table = '<Dependencies><ToolOffsetTable src="tool.tbl" {}/></Dependencies>'
        self.machine(table.format('unit="inch" size="500"'))
        part = self.write("part.nc", "G21 G90 G54 G43 H1 Z10.\nM30\n")
        done = self.run_it("run", part, "-m", "machines/mill", "--emit", "motions", "--format", "csv")
        self.assertIn(",60.8,", done.stdout)  # 10 mm and 2 in of 25.4 mm
        self.assertNotIn("TAB-0112", done.stderr)
        for options, code in (('units="inch"', "IG-0140"), ('unit="foot"', "IG-0205"), ('size="x"', "IG-0205")):
            self.machine(table.format(options))
            done = self.run_it("lint", "-m", "machines/mill", status=1)
            self.assertRegex(done.stderr, rf"machine\.xml:2:47: error: .*\[{code}\]")
            self.assertEqual(done.stderr.count("error:"), 1, done.stderr)
        self.machine('<Dependencies><ToolOffsetTable unit="inch"/></Dependencies>')
        self.assertIn("[IG-0204]", self.run_it("lint", "-m", "machines/mill", status=1).stderr)

    def test_a_machine_is_written_as_a_file_of_its_control(self):
        self.machine('<Dependencies><ToolOffsetTable><Tool id="1" H="98.2" D="5" Name="EM10" CornerRadius="1"/>'
                     '<Tool id="1.2" H="99"/><Tool id="2" H="90" Teeth="4" CornerRadius="0.5"/></ToolOffsetTable>'
                     '<IsoCoordinateTable><Offset id="G54" X="1"/><Offset id="G59.3" Y="2"/></IsoCoordinateTable>'
                     '</Dependencies>')
        here = ["-m", "machines/mill"]
        self.assertIn("[IG-0131]", self.run_it("export", *here, "--format", "LinuxCncToolTable", status=2).stderr)
        written = []
        for one in json.loads(self.run_it("list", "importers", "--json").stdout):
            self.assertTrue(one["HasPage"], one["Id"])
            if not one["Writes"]:
                continue
            left = self.run_it("export", *here, "--format", one["Id"], "-o", "table.txt").stderr
            back = self.run_it("import", "table.txt", "--format", one["Id"]).stdout
            if "ToolOffsetTable" in one["Tables"] and "rows of ToolOffsetTable" not in left:
                self.assertIn('H="98.2"', back, one["Id"])
                written.append(one["Id"])
        self.assertGreaterEqual(len(written), 3, "formats of tools that are written")
        done = self.run_it("export", *here, "--format", "FanucOffsets")
        left = [line for line in done.stderr.splitlines() if "[IG-0133]" in line]
        self.assertEqual([re.sub(r".*note: (.*) has no place in the file: .*count: (\d+).*", r"\1 \2", line)
                          for line in left],
                         ["row G59.3 1", "rows with an index 1", "column CornerRadius of ToolOffsetTable 2",
                          "column Name of ToolOffsetTable 1", "column Teeth of ToolOffsetTable 1"])

    def test_rows_whose_names_differ_in_their_letters_alone_are_one(self):
        self.machine('<Dependencies><HeidenhainPoints><Point id="vice.pnt#1" X="1"/><Point id="VICE.PNT#1" X="2"/>'
                     '</HeidenhainPoints></Dependencies>')
        done = self.run_it("export", "-m", "machines/mill", "--format", "HeidenhainPointTable")
        self.assertRegex(done.stdout, r"\n1 +\+1 ")
        self.assertRegex(done.stderr, r"row VICE\.PNT#1 has no place in the file.*\[IG-0133\]")

    def test_parameters_that_a_fanuc_cannot_hold_are_named(self):
        rows = "".join(f'<Parameter number="{number}" {column}="{value}"/>' for number, column, value in (
            (3401, "Value", 256), (5101, "Value", -1), (1202, "Value", 0.5), (1221, "X", 5), (5114, "X", 3)))
        self.machine(f"<Dependencies><FanucParameterTable>{rows}</FanucParameterTable></Dependencies>")
        done = self.run_it("export", "-m", "machines/mill", "--format", "FanucParameters")
        self.assertRegex(done.stderr, r"value of bits has no place in the file.*count: 3")
        self.assertRegex(done.stderr, r"parameter 1221 has no place in the file")
        self.assertRegex(done.stderr, r"value of an axis of parameter 5114 has no place in the file")
        self.assertNotRegex(done.stdout, "N0(3401|5101|1202|1221)")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.isogloss = OPTIONS.isogloss.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
