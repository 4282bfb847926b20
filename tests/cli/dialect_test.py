#!/usr/bin/env python3
"""What an integrator asks of a dialect: where a syntax comes from, what differs, what has no effect, how to mend it."""
import argparse
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

OPTIONS = None
NAMESPACE = 'xmlns="urn:isogloss:dialect:1"'


class Command(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def run_it(self, *arguments, status=0):
        environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")}
        done = subprocess.run([OPTIONS.isogloss, *arguments, *OPTIONS.more], capture_output=True, text=True, timeout=60,
                              check=False, cwd=self.path, env=environment)
        self.assertEqual(done.returncode, status, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done

    def write(self, text, name="mine.xml"):
        (self.path / name).write_text(text)
        return name

    def mine(self, chain="", before="", extends="iso", name="mine.xml"):
        chain = f"  <Chain>\n{chain}  </Chain>\n" if chain else ""
        return self.write(f'<Dialect {NAMESPACE} name="{name[:-4]}" extends="{extends}">\n{before}{chain}</Dialect>\n',
                          name)


class Why(Command):
    def test_the_file_the_options_and_the_neighbours_are_named(self):
        text = self.run_it("dialect", "syntec", "--why", "DwellSyntax").stdout
        self.assertRegex(text, r"iso\.xml:\d+: listed in the chain of dialect iso")
        self.assertRegex(text, r"fanuc\.xml:\d+: configured by dialect fanuc")
        self.assertRegex(text, r'p-unit="by-point"  .*syntec\.xml:\d+')
        self.assertIn("takes: G04", text)
        self.assertIn("\nafter:", text)

    def test_an_edit_is_named_with_its_dialect(self):
        text = self.run_it("dialect", "syntec", "--why", "SyntecCodeSyntax").stdout
        self.assertRegex(text, r"syntec\.xml:\d+: put in by dialect syntec, <InsertBefore> of CannedCycleResolveSyntax")

    def test_reasons_are_declarations_fields_and_codes(self):
        found = json.loads(self.run_it("dialect", "fanuc", "--why", "IncrementalResolveSyntax", "--json").stdout)
        reasons = [b for n in found["MustFollow"] + found["MustPrecede"] for b in n["Because"]]
        self.assertTrue(any("declare" in r for r in reasons), reasons)
        self.assertTrue(any(re.search(r"writes \S+.*, which IncrementalResolveSyntax reads", r) for r in reasons))
        declared = [n["Syntax"] for n in found["MustFollow"] if n["Declared"]]
        page = json.loads(self.run_it("inspect", "IncrementalResolveSyntax", "--json").stdout)
        self.assertLessEqual(set(page["After"]) & {n["Syntax"] for n in found["MustFollow"]}, set(declared))

    def test_what_was_taken_out_and_what_is_misspelt(self):
        done = self.run_it("dialect", "syntec", "--why", "FanucToolCallSyntax", status=1)
        self.assertRegex(done.stderr, r"hint: dialect syntec takes it out: .*syntec\.xml:\d+, <Remove>")
        done = self.run_it("dialect", "iso", "--why", "DwelSyntax", status=1)
        self.assertIn("[IG-0172]", done.stderr)
        self.assertIn("did you mean DwellSyntax?", done.stderr)
        self.assertEqual(done.stdout, "")
        done = self.run_it("dialect", "fanuc", "--why", "G83", status=1)
        self.assertIn("it is a code of programs: isogloss inspect G83 -d fanuc", done.stderr)


class Graph(Command):
    def test_the_text_and_the_json_hold_the_whole_chain_in_order(self):
        chain = json.loads(self.run_it("dialect", "fanuc", "--graph", "--json").stdout)
        text = self.run_it("dialect", "fanuc", "--graph").stdout
        syntaxes = [s for stage in chain["Stages"] for s in stage["Syntaxes"]]
        self.assertEqual([s["Position"] for s in syntaxes], list(range(1, len(syntaxes) + 1)))
        self.assertEqual(re.findall(r"(?m)^ *\d+ (\w+)", text), [s["As"] for s in syntaxes])
        place = {s["As"]: s["Position"] for s in syntaxes}
        for s in syntaxes:
            self.assertTrue(all(place[a] < s["Position"] for a in s["After"]))
            self.assertTrue(all(place[b] > s["Position"] for b in s["Before"]))
            self.assertTrue(all(place[r] > s["Position"] for w in s["Writes"] for r in w["For"]))
        self.assertEqual([s["Stage"] for s in chain["Stages"]],
                         ["Parsing", "Evaluation", "Logic", "PostLogic", "Inspection"])

    def test_the_drawing_has_a_box_for_each_syntax_and_an_arc_for_each_relation(self):
        text = self.run_it("dialect", "iso", "--graph", "-o", "iso.svg").stdout
        self.assertIn("Parsing\n", text)
        drawing = ElementTree.parse(self.path / "iso.svg").getroot()
        chain = json.loads(self.run_it("dialect", "iso", "--graph", "--json").stdout)
        syntaxes = [s for stage in chain["Stages"] for s in stage["Syntaxes"]]
        svg = "{http://www.w3.org/2000/svg}"
        self.assertEqual(len(drawing.findall(f".//{svg}g")), len(syntaxes))
        arcs = [p.get("class") for p in drawing.iter(f"{svg}path")]
        self.assertEqual(arcs.count("order"), sum(len(s["Before"]) for s in syntaxes))
        self.assertEqual(arcs.count("field"), sum(len({r for w in s["Writes"] for r in w["For"]}) for s in syntaxes))


class Difference(Command):
    def test_the_same_dialect_has_none(self):
        self.assertEqual(self.run_it("dialect", "fanuc", "--diff", "fanuc").stdout, "")
        self.assertTrue(json.loads(self.run_it("dialect", "fanuc", "--diff", "fanuc", "--json").stdout)["Same"])

    def test_each_kind_is_one_row(self):
        other = self.mine('<Configure syntax="DwellSyntax" p-unit="ms"/><Remove syntax="ScalingSyntax"/>'
                          '<Remove syntax="PlaneSelectSyntax"/>'
                          '<InsertAfter syntax="ToolChangeSyntax"><PlaneSelectSyntax/></InsertAfter>',
                          '<Plugins><Plugin name="fanuc"/></Plugins>'
                          '<Dependencies><IsoCoordinateTable><Offset id="G55" X="3"/></IsoCoordinateTable>'
                          '</Dependencies><Initial><Field path="MotionState.Term" value="G01"/></Initial>')
        rows = json.loads(self.run_it("dialect", "iso", "--diff", other, "--json", status=1).stdout)["Differences"]
        found = {(r["Part"], r["Name"]): (r["Left"], r["Right"]) for r in rows}
        self.assertEqual(found["option", "DwellSyntax p-unit"], ("s", "ms"))
        self.assertEqual(found["plugin", "fanuc"], (None, "named"))
        self.assertEqual(found["initial", "MotionState.Term"], ("G00", "G01"))
        self.assertEqual(found["row", "IsoCoordinateTable G55.X"], (None, "3"))
        self.assertIsNone(found["chain", "ScalingSyntax"][1])
        self.assertIn("after ToolChangeSyntax", found["moved", "PlaneSelectSyntax"][1])
        self.assertEqual(len(found), len(rows))
        self.assertRegex({r["Name"]: r for r in rows}["DwellSyntax p-unit"]["RightPlace"], r"mine\.xml:\d+")
        text = self.run_it("dialect", "iso", "--diff", other, status=1).stdout
        self.assertRegex(text, r"option +DwellSyntax p-unit +s +\| ms\n")
        self.assertEqual(len(text.splitlines()), len(rows) + 1)
        back = json.loads(self.run_it("dialect", other, "--diff", "iso", "--json", status=1).stdout)["Differences"]
        self.assertEqual({(r["Part"], r["Name"]): r["Left"] for r in back}["chain", "ScalingSyntax"], None)
        self.assertEqual(len(back), len(rows))

    def test_trouble_is_2(self):
        for arguments in (("iso", "--diff", "fanucc"), ("isoo", "--diff", "iso"), ("iso", "--diff", "iso", "--graph")):
            self.assertEqual(self.run_it("dialect", *arguments, status=2).stdout, "")


class Effective(Command):
    def test_annotated_it_says_where_each_part_comes_from_and_loads_back(self):
        self.run_it("dialect", "--effective", "syntec", "--annotate", "-o", "noted.xml")
        noted = (self.path / "noted.xml").read_text()
        self.assertRegex(noted, r"<!-- \S*iso\.xml:\d+; p-unit: \S*syntec\.xml:\d+ -->\s*<DwellSyntax p-unit")
        self.assertRegex(noted, r'<!-- \S*syntec\.parameters\.xml:\d+ -->\s*<Parameter number="\d+"')
        mine = self.mine(before='  <Severities>\n    <Severity code="IG-0212" is="note"/>\n  </Severities>\n')
        self.assertRegex(self.run_it("dialect", mine, "--annotate").stdout,
                         r'<!-- mine\.xml:3 -->\s*<Severity code="IG-0212"')
        plain = self.run_it("dialect", "syntec").stdout
        self.assertNotIn("<!--", plain)
        self.assertEqual(self.run_it("dialect", "noted.xml").stdout, plain)


class Lint(Command):
    def said(self, *arguments, code, status=0, **dialect):
        done = self.run_it("lint", self.mine(*arguments, **dialect), status=status)
        lines = [line for line in done.stderr.splitlines() if line.endswith(f"[{code}]")]
        self.assertEqual(len(lines), 1, done.stderr)
        return lines[0]

    def test_shipped_dialects_are_clean(self):
        names = [d["Name"] for d in json.loads(self.run_it("list", "dialects", "--json").stdout)]
        done = self.run_it("lint", *names)
        self.assertNotRegex(done.stderr, r"\[IG-01[67]\d\]")

    def test_a_syntax_that_nothing_wakes(self):
        self.write(f'<Dialect {NAMESPACE} name="few"><Segmenter type="line"/><Plugins><Plugin name="iso"/></Plugins>'
                   "<Chain><Parsing><WordSyntax/></Parsing><Logic>\n<FeedrateSyntax/>\n<DwellSyntax/>\n</Logic></Chain>"
                   "</Dialect>", "few.xml")
        done = self.run_it("lint", "few.xml")
        self.assertRegex(done.stderr, r"few\.xml:3:1: warning: DwellSyntax is never called: nothing in this chain "
                                      r"writes Parsing\.\S*G04\S* \[IG-0165\]")
        self.assertNotIn("FeedrateSyntax is never", done.stderr)

    def test_an_option_that_repeats_the_default(self):
        self.assertIn("the option p-unit of DwellSyntax repeats the default, 's'",
                      self.said('<Configure syntax="DwellSyntax" p-unit="s"/>\n', code="IG-0166"))
        done = self.run_it("lint", self.mine('<Configure syntax="DwellSyntax" p-unit="s"/>\n', extends="fanuc"))
        self.assertNotIn("IG-0166", done.stderr)  # Fanuc counts milliseconds, so it is set back

    def test_an_edit_that_repeats_what_is_inherited(self):
        self.assertRegex(self.said('<Configure syntax="DwellSyntax" p-unit="ms"/>\n', code="IG-0167", extends="fanuc"),
                         r"sets p-unit of DwellSyntax to 'ms', which \S*fanuc\.xml:\d+ has set already")
        self.assertIn("the plugin iso repeats", self.said("", '<Plugins><Plugin name="iso"/></Plugins>\n',
                                                          code="IG-0170"))
        self.assertIn("the initial value of MotionState.Term repeats",
                      self.said("", '<Initial><Field path="MotionState.Term" value="G00"/></Initial>\n',
                                code="IG-0170"))

    def test_an_edit_that_is_taken_back(self):
        self.assertRegex(self.said('<Configure syntax="DwellSyntax" p-unit="ms"/>\n<Remove syntax="DwellSyntax"/>\n',
                                   code="IG-0168"), r":3:1: warning: <Configure> of DwellSyntax has no effect: <Remove>")
        self.assertRegex(self.said('<Configure syntax="DwellSyntax" p-unit="ms"/>\n'
                                   '<Configure syntax="DwellSyntax" p-unit="by-point"/>\n', code="IG-0168"),
                         r":3:\d+: warning: p-unit of DwellSyntax has no effect: <Configure> at .*:4")

    def test_an_edit_without_options_and_an_override_without_a_rival(self):
        self.said('<Configure syntax="DwellSyntax"/>\n', code="IG-0169")
        self.said('<Replace syntax="DwellSyntax"><DwellSyntax override="true"/></Replace>\n', code="IG-0171")


class Dropped(Command):
    """Codes and words that nothing takes any longer."""

    def lint(self, edit, extends="fanuc"):
        path = self.mine(f"    {edit}\n", extends=extends)
        return path, self.run_it("lint", path).stderr

    def test_a_note_stands_at_the_edit(self):
        path, said = self.lint('<Remove syntax="UnitModeSyntax"/>')
        self.assertRegex(said, r"mine\.xml:\d+:5: note: nothing")
        self.assertIn("nothing takes G20, G21, G70, G71 any longer, as UnitModeSyntax does in fanuc: programs that "
                      "hold them are reported [IG-0611]", said)
        program = self.write("G21 G90\nM30\n", "a.nc")
        self.assertIn("G21", self.run_it("run", program, "-d", path, "--emit", "none", status=1).stderr)

    def test_what_another_syntax_takes_is_not_lost(self):
        for chain in ('<Configure syntax="DwellSyntax" p-unit="s"/>',
                      '<Replace syntax="UnitModeSyntax"><UnitModeSyntax as="Mine"/></Replace>'):
            self.assertNotIn("IG-0611", self.lint(chain)[1], chain)

    def test_shipped_dialects_lose_nothing_that_nobody_noted(self):
        self.assertNotIn("IG-0611", self.run_it("lint", "fanuc", "haas", "syntec", "siemens", "heidenhain").stderr)


class IdleRows(Command):
    """Rows of tables of parameters that nothing acts on."""

    def said(self, rows, table="FanucParameterTable", row="Parameter", dialect="fanuc"):
        rows = "\n".join(f'<{row} number="{number}" {cells}/>' for number, cells in rows)
        return self.run_it("lint", self.mine(before=f"<Dependencies><{table}>\n{rows}\n</{table}></Dependencies>\n",
                                             extends=dialect)).stderr

    def test_a_number_that_no_syntax_knows(self):
        said = self.said([("3401", 'Value="1"'), ("1302", 'Value="5"'), ("1321", 'X="-500"'), ("9", 'Value="1"')])
        self.assertRegex(said, r"mine\.xml:\d+:1: note: FanucParameterTable has no use for 1302, 9: is the number right, "
                               r"and the column\? \[IG-0613\]")
        many = self.said([(str(number), 'Value="1"') for number in range(9000, 9012)])
        self.assertIn("has no use for 9000, 9001, 9002, 9003, 9004, 9005, 9006, 9007 and 4 more", many)

    def test_a_column_that_the_parameter_has_no_use_for(self):
        said = self.said([("1320", 'Value="500"'), ("3401", 'Value="1" X="1"'), ("1420", 'X="1000"')])
        self.assertIn("has no use for 1320.Value, 3401.X: is", said)

    def test_parameters_that_act(self):
        for said in (self.said([("6050", 'Value="100"'), ("6079", 'Value="77"'), ("6089", 'Value="78"')]),
                     self.said([("3601", 'Value="77"'), ("3710", 'Value="2"')], "SyntecParameterTable",
                               dialect="syntec"),
                     self.said([("9", 'Value="1"')], "HaasSettings", "Setting", "haas"),
                     self.run_it("lint", "fanuc", "haas", "syntec", "mazak", "okuma").stderr):
            self.assertNotIn("IG-0613", said)
        self.assertIn("HaasSettings has no use for 10:",
                      self.said([("10", 'Value="1"')], "HaasSettings", "Setting", "haas"))


class Suggest(Command):
    def suggested(self, dialect):
        """The patch with the line ends of the file."""
        environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")}
        done = subprocess.run([OPTIONS.isogloss, "lint", dialect, "--suggest", *OPTIONS.more], cwd=self.path,
                              capture_output=True, check=False, env=environment)
        self.assertEqual(done.returncode, 1, done.stderr)
        return done.stdout.decode()

    def apply(self, dialect, count=None):
        """The patch applies with both tools; the order is right afterwards. How many lines it adds."""
        self.run_it("lint", dialect, status=1)
        patch = self.suggested(dialect)
        (self.path / "order.patch").write_bytes(patch.encode())
        self.assertIn("@@", patch)
        check = subprocess.run(["git", "apply", "-p0", "--check", "order.patch"], cwd=self.path, capture_output=True,
                               text=True, check=False)
        self.assertEqual(check.returncode, 0, check.stderr + patch)
        tool = ["patch", "-p0", "--binary", "-i", "order.patch"] if shutil.which("patch") else ["git", "apply", "-p0", "order.patch"]
        done = subprocess.run(tool, cwd=self.path, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr + patch)
        after = self.run_it("lint", dialect)
        self.assertNotRegex(after.stderr, r"\[IG-01[67]\d\]", patch)
        added = sum(line.startswith("+") and not line.startswith("+++") for line in patch.splitlines())
        if count is not None:
            self.assertEqual(added, count, patch)
        return added

    def test_a_root_dialect_gets_a_line_moved(self):
        self.run_it("dialect", "--effective", "iso", "-o", "whole.xml")
        lines = (self.path / "whole.xml").read_text().splitlines(keepends=True)
        at = {re.match(r"\s*<(\w+)", line)[1]: i for i, line in enumerate(lines) if re.match(r"\s*<\w", line)}
        moved = lines.pop(at["PlaneSelectSyntax"])
        lines.insert(at["LinearMotionSyntax"], moved)
        (self.path / "whole.xml").write_text("".join(lines))
        self.apply("whole.xml", count=1)

    def test_many_wrong_orders_are_mended_and_no_more_moves_than_were_made(self):
        effective = self.run_it("dialect", "--effective", "fanuc").stdout.splitlines(keepends=True)
        begin = next(i for i, line in enumerate(effective) if "<Logic>" in line) + 1
        end = next(i for i, line in enumerate(effective) if "</Logic>" in line)
        chance = random.Random(20)
        mended = 0
        for _ in range(12):
            lines = list(effective)
            moves = chance.randint(1, 4)
            for _ in range(moves):
                lines.insert(chance.randrange(begin, end - 1), lines.pop(chance.randrange(begin, end)))
            (self.path / "whole.xml").write_text("".join(lines))
            environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")}
            wrong = subprocess.run([OPTIONS.isogloss, "lint", "whole.xml", *OPTIONS.more], cwd=self.path, text=True,
                                   capture_output=True, check=False, env=environment)
            if wrong.returncode == 1:
                self.assertLessEqual(self.apply("whole.xml"), moves)
                mended += 1
        self.assertGreater(mended, 5)

    def test_an_edit_gets_another_anchor(self):
        name = self.mine('    <Remove syntax="McXyzSyntax"/>\n'
                         '    <InsertBefore syntax="ProgramXyzSyntax"> <McXyzSyntax/> </InsertBefore>\n')
        self.apply(name, count=1)
        self.assertIn("McXyzSyntax", (self.path / name).read_text())

    def test_one_of_two_elements_leaves_its_edit(self):
        name = self.mine('    <Remove syntax="McXyzSyntax"/>\n    <Remove syntax="PlaneSelectSyntax"/>\n'
                         '    <InsertAfter syntax="ToolChangeSyntax">\n      <PlaneSelectSyntax/>\n'
                         '      <McXyzSyntax/>\n    </InsertAfter>\n')
        self.apply(name)

    def test_the_smallest_change_is_the_one_that_leaves_what_is_inherited(self):
        """One inherited element and two of the dialect's own stand the wrong way round: to move both is the smaller change."""
        chain = ('    <Remove syntax="McXyzSyntax"/>\n'
                 '    <InsertBefore syntax="ProgramXyzSyntax"> <McXyzSyntax/> <McXyzSyntax as="Again"/> </InsertBefore>\n')
        name = self.mine(chain)
        self.apply(name)
        text = (self.path / name).read_text()
        self.assertNotIn('<Remove syntax="ProgramXyzSyntax"/>', text, "what is inherited stays")
        self.assertNotIn("<ProgramXyzSyntax", text)

    def test_what_is_inherited_is_put_in_again_where_nothing_of_ones_own_can_move(self):
        self.write_base()
        name = self.mine('    <Configure syntax="DwellSyntax" p-unit="ms"/>\n', extends="base")
        self.apply(name, count=2)

    def test_comments_and_line_ends_of_any_form(self):
        """Tags in a comment are none, and lines may end with a return."""
        edits = ('    <Remove syntax="McXyzSyntax"/>\n    <InsertBefore syntax="ProgramXyzSyntax">{}\n'
                 '      <McXyzSyntax></McXyzSyntax>\n    </InsertBefore>\n')
        self.apply(self.mine(edits.format(' <!-- </InsertBefore> "> -->')))
        for line_end in (b"\r\n", b"\r"):
            name = self.mine(edits.format(""))
            text = (self.path / name).read_bytes().replace(b"\n", line_end)
            (self.path / name).write_bytes(text)
            self.apply(name)
            self.assertIn(b"<McXyzSyntax></McXyzSyntax>", (self.path / name).read_bytes())
        name = self.mine(edits.format(""))
        (self.path / name).write_bytes(b"\xef\xbb\xbf" + (self.path / name).read_bytes().replace(b"\n", b""))
        self.apply(name)

    def test_the_end_of_the_chain_is_found(self):
        self.write_base()
        for end in ("  </Chain >\n", "  </Chain>\n  <!-- </Chain> -->\n"):
            name = self.mine('    <Configure syntax="DwellSyntax" p-unit="ms"/>\n', extends="base")
            path = self.path / name
            path.write_text(re.sub(r" *<Configure.*\n", "", path.read_text()).replace("  </Chain>\n", end))
            self.apply(name, count=2)

    def write_base(self):
        """The dialect base, which has iso's chain with one syntax in a wrong place."""
        text = self.run_it("dialect", "--effective", "iso").stdout.replace('name="iso"', 'name="base"', 1)
        plane = re.search(r" *<PlaneSelectSyntax.*/>\n", text)[0]
        self.write(text.replace(plane, "", 1).replace("    </Logic>", plane + "    </Logic>", 1), "base.xml")

    def test_a_right_order_and_an_impossible_one(self):
        self.assertIn("iso: the order is right", self.run_it("lint", "iso", "--suggest").stdout)


class Inspect(Command):
    def test_a_code_shows_its_syntax_and_page(self):
        done = self.run_it("inspect", "G83", "-d", "fanuc")
        self.assertTrue(done.stdout.startswith("G83 in fanuc: CannedCycleResolveSyntax (iso/"))
        self.assertTrue(re.search(r"\nG83 in fanuc: PeckDrillingCycleSyntax \(iso/\S+\.md\), \S*iso\.xml:\d+\n",
                                  done.stdout))
        self.assertIn("\n# PeckDrillingCycleSyntax\n", done.stdout)
        self.assertIn("G04 in fanuc: DwellSyntax", self.run_it("inspect", "g4", "-d", "fanuc").stdout)
        found = json.loads(self.run_it("inspect", "G83", "-d", "fanuc", "--json").stdout)
        self.assertEqual(found["Syntaxes"][1]["Link"]["As"], "PeckDrillingCycleSyntax")
        done = self.run_it("inspect", "G999", "-d", "fanuc", status=2)
        self.assertIn("no syntax of fanuc answers 'G999'", done.stderr)
        self.assertIn("[IG-0173]", done.stderr)
        self.assertIn("name the dialect: -d", self.run_it("inspect", "G83", status=2).stderr)

    def test_a_section_alone(self):
        page = self.run_it("inspect", "DwellSyntax", "--section", "diagnostics").stdout
        self.assertTrue(page.startswith("## Diagnostics\n"))
        self.assertNotIn("## X in seconds", page)
        self.assertNotIn("---- declaration", page)
        pages = [s["Page"] for s in json.loads(self.run_it("inspect", "A", "-d", "fanuc", "--json").stdout)["Syntaxes"]]
        expected = sum("\n## Diagnostics\n" in page for page in pages)
        self.assertGreater(expected, 1)
        page = self.run_it("inspect", "A", "-d", "fanuc", "--section", "Diagnostics").stdout
        self.assertEqual(page.count("## Diagnostics\n"), expected, "one of each page that has it")
        done = self.run_it("inspect", "DwellSyntax", "--section", "Diagnostic", status=1)
        self.assertIn("[IG-0174]", done.stderr)
        self.assertIn("did you mean Diagnostics?", done.stderr)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True)
    parser.add_argument("--more", nargs="*", default=[], help="options for each command, as name=value")
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.isogloss = str(pathlib.Path(OPTIONS.isogloss).resolve())
    OPTIONS.more = [f"--{one}" for one in OPTIONS.more]
    unittest.main(argv=[sys.argv[0], *rest])
