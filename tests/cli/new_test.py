#!/usr/bin/env python3
"""What `isogloss new plugin` and `new dialect` write and refuse; tests/out_of_tree builds what they write.

  new_test.py --isogloss PATH
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

OPTIONS = None


class New(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def new(self, *arguments, status=0):
        environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")}
        done = subprocess.run([OPTIONS.isogloss, "new", *arguments], capture_output=True, text=True, timeout=60,
                              check=False, cwd=self.path, env=environment)
        self.assertEqual(done.returncode, status, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done

    def refused(self, code, *arguments):
        before = sorted(self.path.rglob("*"))
        done = self.new(*arguments, status=2)
        self.assertIn(f"[{code}]", done.stderr, arguments)
        self.assertEqual(done.stdout, "")
        self.assertEqual(sorted(self.path.rglob("*")), before, "nothing is written")

    def test_stdout_lists_every_file(self):
        done = self.new("plugin", "acme")
        files = sorted(str(path.relative_to(self.path)) for path in self.path.rglob("*") if path.is_file())
        self.assertEqual(sorted(done.stdout.splitlines()), files)
        self.assertIn("acme/acme_g181_cycle_syntax.cpp", files)
        self.assertIn("cmake -S . -B build", done.stderr)
        self.assertTrue(os.access(self.path / "acme/ci.sh", os.X_OK))

    def test_every_mark_of_a_template_is_filled(self):
        for name, more in (("a-1", ["--prefix", "AONE"]), ("b-word", ["--word", "E"]), ("c-word", ["--word", "e", "--language", "c"]),
                           ("d-table", ["--table", "clamp-table"]),
                           ("e-table", ["--table", "clamp-table", "--language", "c", "--extends", "siemens"]),
                           ("c-drill", ["--cycle", "G181", "--language", "c"]),
                           ("h-word", ["--word", "E", "--extends", "heidenhain"]),
                           ("i-table", ["--table", "x", "--language", "c", "--extends", "heidenhain"]),
                           ("f-switch", ["--switch", "m270,m271"]), ("g-switch", ["--language", "c", "--extends", "heidenhain"])):
            self.new("plugin", name, *more)
        self.new("dialect", "turned", "--extends", "siemens", "--in", "elsewhere")
        for path in self.path.rglob("*"):
            if path.is_file():
                self.assertNotRegex(f"{path.name} {path.read_text()}", r"@\w*@")
        files = {path.name for path in (self.path / "elsewhere/turned").rglob("*") if path.is_file()}
        self.assertEqual(files, {".gitignore", "CMakeLists.txt", "README.md", "changelog", "ci.sh", "copyright", "turned.xml", "slot.spf",
                                 "slot.expected"})
        self.assertIn("LANGUAGES C)", (self.path / "c-word/CMakeLists.txt").read_text())

    def test_a_plugin_begins_with_what_its_dialect_can_have(self):
        for name, more, file in (("acme-one", [], "acme_one_g181_cycle_syntax.cpp"),
                                 ("acme-two", ["--language", "c"], "acme_two_g181_cycle_syntax.c"),
                                 ("acme-three", ["--extends", "siemens"], "acme_three_switch_syntax.cpp"),
                                 ("acme-four", ["--extends", "heidenhain"], "acme_four_switch_syntax.cpp"),
                                 ("acme-five", ["--extends", "siemens", "--word", "E"], "acme_five_word_syntax.cpp"),
                                 ("acme-six", ["--extends", "heidenhain", "--word", "E"], "acme_six_statement_syntax.cpp")):
            self.assertIn(f"{name}/{file}", self.new("plugin", name, *more).stdout.splitlines())
        self.assertIn("BEGIN PGM", (self.path / "acme-four/tests/switch.h").read_text())
        self.assertIn("FUNCTION ACME-SIX E30", (self.path / "acme-six/tests/word.h").read_text())
        self.assertFalse((self.path / "acme-six/tests/word.nc").exists())
        self.assertIn("run tests/switch.h -d", (self.path / "acme-four/README.md").read_text())
        self.assertTrue((self.path / "acme-five/tests/word.nc").read_text().startswith("G17 G90\n"))
        self.assertIn('"M171"', (self.path / "acme-three/acme_three_switch_syntax.cpp").read_text())

    def test_names_follow_from_the_name(self):
        self.new("plugin", "acme-clamp", "--table", "Tables", "--word", "E")
        source = (self.path / "acme-clamp/acme_clamp_tables_word_syntax.cpp").read_text()
        for part in ("namespace acme_clamp {", '"AcmeClampTablesWordSyntax"', '"Parsing.E"', '"ACME-0001"'):
            self.assertIn(part, source)

    def test_titles_and_vendors_are_quoted(self):
        self.new("plugin", "acme", "--title", 'A & "B" <C>', "--vendor", 'Acme "Clamps"')
        self.assertIn('title="A &amp; &quot;B&quot; &lt;C&gt;"', (self.path / "acme/dialects/acme.xml").read_text())
        self.assertIn(r'"Acme \"Clamps\""', (self.path / "acme/plugin.cpp").read_text())
        self.assertRegex((self.path / "acme/copyright").read_text(), r'Copyright: 20\d\d Acme "Clamps"\n')
        self.new("plugin", "marked", "--title", "@vendor@ at @base@", "--prefix", "MRK")
        self.assertIn('title="@vendor@ at @base@"', (self.path / "marked/dialects/marked.xml").read_text())

    def test_a_backup_that_cannot_be_copied_makes_no_machine(self):
        (self.path / "card").mkdir()
        (self.path / "card/TOOL.T").write_text("")
        for backup, folder in ((".", "machines"), ("card", "card/machines"), ("card", "card"), ("nothing", "machines")):
            self.refused("IG-0510", "machine", "mill", "-d", "fanuc", "--backup", "card/TOOL.T", "--backup", backup,
                         "--in", folder)

    def test_the_unit_of_p_is_that_of_the_base(self):
        for base, unit, p in (("fanuc", "ms", "P500 "), ("iso", "s", "P.5 ")):
            self.new("plugin", "on-" + base, "--extends", base, "--prefix", "ONB")
            self.assertIn(f'p-unit="{unit}"', (self.path / f"on-{base}/dialects/on-{base}.xml").read_text())
            self.assertIn(p, (self.path / f"on-{base}/tests/g181.nc").read_text())

    def test_sources_are_formatted(self):
        if shutil.which("clang-format") is None:
            self.skipTest("clang-format is not installed")
        for name, more in (("acme", []), ("word", ["--word", "E"]), ("c-word", ["--word", "E", "--language", "c"]),
                           ("tab", ["--table", "ClampTable"]), ("c-tab", ["--table", "ClampTable", "--language", "c"]),
                           ("drl", ["--language", "c"]), ("swi", ["--switch", "M171,M172"]),
                           ("tnc", ["--word", "E", "--extends", "heidenhain"]),
                           ("c-tnc", ["--table", "Clamps", "--language", "c", "--extends", "heidenhain"]), ("c-swi", ["--switch", "M171,M172", "--language", "c"])):
            self.new("plugin", name, "--prefix", "ACM", *more)
            sources = [path for path in (self.path / name).iterdir() if path.suffix in (".cpp", ".hpp", ".c", ".h")]
            done = subprocess.run(["clang-format", "--dry-run", "--Werror", *sources], capture_output=True, text=True,
                                  check=False)
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_bad_names_are_refused(self):
        for name in ("3axis", "a b", "a--b", "a-", "a/b", "../a", "class", "test", "ä", "a" * 41):
            self.refused("IG-0150", "plugin", name)
            self.refused("IG-0150", "dialect", name)
        self.refused("IG-0150", "plugin", "acme", "--table", "a b")

    def test_what_exists_is_not_touched(self):
        (self.path / "acme").mkdir()
        self.refused("IG-0151", "plugin", "acme")
        self.refused("IG-0151", "dialect", "acme")
        self.refused("IG-0151", "plugin", "kinematics")
        self.refused("IG-0151", "dialect", "haas")

    def test_prefixes(self):
        self.refused("IG-0152", "plugin", "acme", "--prefix", "FAN")
        self.refused("IG-0152", "plugin", "acme", "--prefix", "IG")
        for prefix in ("A", "acme", "ABCDEFGHI", "A1"):
            self.refused("IG-0152", "plugin", "acme", "--prefix", prefix)
        self.refused("IG-0152", "plugin", "x1")  # one letter

    def test_codes_and_words_of_the_base_are_refused(self):
        for code in ("G81", "g1", "G54"):
            self.refused("IG-0153", "plugin", "acme", "--cycle", code)
        for codes in ("M3,M171", "M171,m8"):
            self.refused("IG-0153", "plugin", "acme", "--switch", codes)
            self.refused("IG-0153", "plugin", "acme", "--switch", codes, "--extends", "heidenhain")
        for word in "XZFSTDHPQR":
            self.refused("IG-0153", "plugin", "acme", "--word", word)

    def test_what_has_no_template_is_refused(self):
        self.refused("IG-0154", "plugin", "acme", "--extends", "siemens", "--language", "c", "--cycle", "G181")
        self.refused("IG-0154", "plugin", "acme", "--extends", "siemens", "--cycle", "G181")
        self.refused("IG-0154", "plugin", "acme", "--extends", "heidenhain", "--cycle", "G181")

    def test_options_that_do_not_fit(self):
        self.refused("IG-0513", "plugin", "acme", "--backup", "x")
        self.refused("IG-0513", "dialect", "acme", "--word", "E")
        self.refused("IG-0513", "machine", "acme", "-d", "fanuc", "--cycle", "G181")
        self.refused("IG-0513", "machine", "acme")
        self.refused("IG-0513", "plugin", "acme", "--cycle", "G181", "--word", "E")
        self.refused("IG-0513", "plugin", "acme", "--switch", "M171,M172", "--word", "E")
        self.refused("IG-0513", "plugin", "acme", "--cycle", "G181", "--table", "ClampTable")
        self.refused("IG-0513", "dialect", "acme", "--switch", "M171,M172")
        for codes in ("M171", "M171,M171", "M171,M172,M173", "G1,M172", "M171,", "M12345,M1"):
            self.refused("IG-0513", "plugin", "acme", "--switch", codes)
        for code in ("M81", "G", "G1.1", "G1234"):
            self.refused("IG-0513", "plugin", "acme", "--cycle", code)
        self.refused("IG-0513", "plugin", "acme", "--word", "EE")
        self.refused("IG-0513", "dialect", "acme", "--extends", "./mine.xml")
        self.refused("IG-0513", "plugin", "acme", "--vendor", "two\nlines")
        self.refused("IG-0101", "dialect", "acme", "--extends", "fanuk")


def main():
    global OPTIONS
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.isogloss = OPTIONS.isogloss.resolve()
    unittest.main(argv=[sys.argv[0], *rest])


main()
