#!/usr/bin/env python3
"""Each misbehaving plugin is refused, caught or survived, with the expected code, stream and exit status."""
import pathlib
import shutil
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "tests" / "support"))

from budget import FACTOR  # noqa: E402: it lies in another folder
from plugin_test_case import OPTIONS, PluginTestCase, main  # noqa: E402

# What doctor says of a library that it does not load: its status is 1, since something in the input is wrong.
REFUSED = {
    "nothing": ("IG-0305", "returned nothing"),
    "zero_size": ("IG-0305", "size"),
    "huge_size": ("IG-0305", "size"),
    "null_name": ("IG-0305", "the plugin's name is null"),
    "null_syntaxes": ("IG-0305", "syntaxes is null"),
    "absurd_count": ("IG-0305", "BadSyntax.fields counts 4000000000"),
    "long_count": ("IG-0305", "BadSyntax.fields"),
    "null_path": ("IG-0305", "field 0 is null"),
    "null_build": ("IG-0305", "neither build, scan nor restart"),
    "bad_default": ("IG-0305", "'11', not a number from 0 to 10"),
    "same_id": ("IG-0305", "'BadSyntax' is declared twice"),
    "other_major": ("IG-0304", "contract version 2, this host speaks 1"),
    "no_entry": ("IG-0302", "no symbol ig_plugin_v1"),
    "undefined_symbol": ("IG-0303", "nobody_defines_this"),
    "throws_in_entry": ("IG-0303", "not today"),
}

# What a run says, and its status.
RUN = {
    "create_refuses": (2, "IG-0308", "BadSyntax"),
    "throws_in_create": (2, "IG-0308", "not in this chain"),
    "declares_another_field": (2, "IG-0308", "the field 'Parsing.Y' stands where the descriptor has 'Parsing.Z'"),
    "declares_more_fields": (2, "IG-0308", "the field 'Parsing.Y' stands where the descriptor has ''"),
    "declares_fewer_options": (2, "IG-0308", "the option '' stands where the descriptor has 'size'"),
    "throws_in_build": (3, "IG-0401", "not this block"),
    "declares_in_build": (3, "IG-0401", "the field 'Feedrate.FeedrateValue' is declared where no syntax is being made"),
    "throws_a_number": (3, "IG-0401", "no std::exception"),
    "fails_silently": (3, "IG-0401", "no reason"),
    "crashes_in_build": (3, "", "segmentation fault in BadSyntax of plugin crashes_in_build"),
    "hangs_in_build": (3, "", "no end of the block in sight in BadSyntax of plugin hangs_in_build"),
    "recurses": (3, "", "segmentation fault in BadSyntax of plugin recurses"),
    "exits_in_build": (3, "", "a call of exit() in BadSyntax of plugin exits_in_build, at work in build()"),
    "quits_in_build": (3, "", "a call of _exit() in BadSyntax of plugin quits_in_build, at work in build()"),
    "smashes_the_stack": (3, "", "in BadSyntax of plugin smashes_the_stack, at work in build()"),
}

# Outside the blocks of a run: what is said in place of one.
OUTSIDE = {
    "exits_in_create": "a call of exit() in BadSyntax of plugin exits_in_create, at work in create()",
    "hangs_in_create": "no end in sight in BadSyntax of plugin hangs_in_create, at work in create()",
    "create_crashes": "segmentation fault in BadSyntax of plugin create_crashes, at work in create()",
    "hangs_in_restart": "no end in sight in BadSyntax of plugin hangs_in_restart, at work in restart()",
    "crashes_in_restart": "segmentation fault in BadSyntax of plugin crashes_in_restart, at work in restart()",
    "hangs_in_destroy": "no end in sight in BadSyntax of plugin hangs_in_destroy, at work in destroy()",
    "crashes_in_destroy": "segmentation fault in BadSyntax of plugin crashes_in_destroy, at work in destroy()",
    "exits_at_load": "a call of exit() while loading the plugin",
    "hangs_at_load": "no end in sight while loading the plugin",
    "quits_in_entry": "a call of _exit() while loading the plugin",
    "hangs_in_entry": "no end in sight while loading the plugin",
}

# Exceptions that leave a function of the contract: the words that name it.
RAW = {
    "lets_out_of_create": "threw an exception out of create(), whose result cannot be trusted: raw create",
    "lets_out_of_destroy": "threw an exception out of destroy(), whose result cannot be trusted: raw destroy",
    "lets_out_of_restart": "threw an exception out of restart(), whose result cannot be trusted: raw restart",
    "lets_out_of_build": "threw an exception out of build(), whose result cannot be trusted: raw build",
    "lets_out_of_scan": "threw an exception out of scan(), whose result cannot be trusted: raw scan",
    "lets_a_number_out": "threw an exception out of build(), whose result cannot be trusted: no std::exception",
    "lets_much_out": "threw an exception out of build(), whose result cannot be trusted: \\x1b[31mxxx",
}

# What the checked table says; the fast one checks nothing that linking has settled.
CHECKED = ["writes_undeclared", "writes_no_field", "takes_undeclared", "status_nonsense", "sets_a_frame_as_number",
           "sets_a_text_as_number"]


class BadPlugins(PluginTestCase):
    def setUp(self):
        super().setUp()
        self.program = self.path / "part.nc"
        self.program.write_text("G90 G54 G21\nG00 X1. Y2. Z3.\nG01 X5. F100.\nM30\n")

    def run_with(self, plugin, *more):
        dialect = self.path / "bad.xml"
        before = "TapeBoundarySyntax" if "scan" in plugin else "ProgramXyzSyntax"
        dialect.write_text(f'<Dialect xmlns="urn:isogloss:dialect:1" name="bad" extends="iso">'
                           f'<Plugins><Plugin name="{plugin}"/></Plugins><Chain>'
                           f'<InsertBefore syntax="{before}"><BadSyntax/></InsertBefore></Chain></Dialect>')
        return self.run_it("run", self.program, "-d", dialect, "--plugins", OPTIONS.plugins / plugin, *more)

    def test_what_is_refused_is_explained(self):
        for plugin, (code, reason) in REFUSED.items():
            with self.subTest(plugin):
                done = self.doctor(OPTIONS.plugins / plugin)
                self.assertEqual(done.returncode, 1, done.stderr)
                line = next(line for line in done.stdout.splitlines() if f"{plugin}.so: " in line)
                self.assertIn(f"[{code}]", line)
                self.assertIn(reason, line)

    def test_a_dialect_that_needs_a_refused_plugin_does_not_start(self):
        for plugin, (code, reason) in REFUSED.items():
            with self.subTest(plugin):
                done = self.run_with(plugin)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertEqual(done.stdout, "")
                line = next(line for line in done.stderr.splitlines() if f"[{code}]" in line)
                self.assertIn(reason, line)
                self.assertRegex(line, r"bad\.xml:1:\d+: error: ")

    def test_others_work_while_one_is_refused(self):
        done = self.run_it("run", self.program, "-d", "iso", "--plugins", OPTIONS.plugins / "zero_size")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn('"rapid"', done.stdout)

    def test_what_goes_wrong_in_a_run_is_told(self):
        for plugin, (status, code, text) in RUN.items():
            with self.subTest(plugin):
                done = self.run_with(plugin, "--watchdog", "1")
                self.assertEqual(done.returncode, status, done.stderr)
                self.assertIn(text, done.stderr)
                self.assertIn(code, done.stderr)
                if status == 3 and code == "":
                    self.assertIn("part.nc:2: G00 X1. Y2. Z3.", done.stderr)

    def test_a_fault_outside_the_blocks_names_plugin_syntax_and_phase(self):
        for plugin, text in OUTSIDE.items():
            with self.subTest(plugin):
                done = self.run_with(plugin, "--watchdog", "1", "-o", self.path / "out.jsonl")
                self.assertEqual(done.returncode, 3, done.stderr)
                self.assertIn(f"internal fault: {text}", done.stderr)
                self.assertIn(plugin, done.stderr)
                self.assertEqual(list(self.path.glob("out.jsonl*")), [])

    def test_an_exception_that_leaves_the_plugin_is_caught_and_told(self):
        for plugin, text in RAW.items():
            with self.subTest(plugin):
                done = self.run_with(plugin)
                self.assertEqual(done.returncode, 3, done.stderr[:1000])
                self.assertIn(f"BadSyntax of plugin {plugin} {text}", done.stderr)
                self.assertIn("[IG-0350]", done.stderr)
                self.assertLess(len(done.stderr), 10_000)
                if plugin not in ("lets_out_of_create",):
                    self.assertIn('"Line":3', done.stdout)

    def test_lint_tells_names_that_nothing_answers_to(self):
        self.run_with("misspells")
        dialect = self.path / "bad.xml"
        dialect.write_text(dialect.read_text().replace("<BadSyntax/>", "<BadSyntax/><WakesItselfSyntax/>"))
        done = self.run_it("lint", dialect, "--plugins", OPTIONS.plugins / "misspells")
        self.assertEqual(done.returncode, 0, done.stderr)
        for said in ("warning: BadSyntax declares that it stands before ProgramXyzSyntx, a syntax that no installed plugin "
                     "has [IG-0177]\n  hint: did you mean ProgramXyzSyntax?",
                     "note: BadSyntax declares that it stands after QueenOfHearts, a syntax that no installed plugin has "
                     "[IG-0177]",
                     "warning: BadSyntax reads Feedrate.FeedrateValu, which no installed plugin writes [IG-0178]\n"
                     "  hint: did you mean Feedrate.FeedrateValue?",
                     "note: BadSyntax reads Wonderland.RabbitHole, which no installed plugin writes [IG-0178]",
                     "warning: the option Size of BadSyntax has a capital letter: options of all other syntaxes are written "
                     "small [IG-0179]",
                     "warning: WakesItselfSyntax is never called: nothing in this chain writes Wonderland.Own [IG-0165]"):
            self.assertIn(said, done.stderr)
        self.assertNotRegex(self.run_it("lint", "iso", "fanuc", "syntec", "siemens", "heidenhain", "okuma", "haas",
                                        "mazak").stderr, r"IG-017[789]")

    def test_a_case_tells_why_its_plugin_is_not_there(self):
        page = self.path / "bad_syntax.md"
        page.write_text("# BadSyntax\n\n## One\n\n#BeforeBuild:\n\n```json\n{}\n```\n\n#AfterBuild:\n\n```json\n{}\n```\n")
        done = self.run_it("case", page, "--plugins", OPTIONS.plugins / "null_build")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("no syntax 'BadSyntax' [IG-0504]", done.stdout)
        self.assertIn("neither build, scan nor restart", done.stdout)
        self.assertIn("[IG-0305]", done.stdout)

    def test_lint_tells_what_create_throws(self):
        self.run_with("lets_out_of_create")
        done = self.run_it("lint", self.path / "bad.xml", "--plugins", OPTIONS.plugins / "lets_out_of_create")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("[IG-0350]", done.stderr)

    def test_a_scanner_cannot_take_what_lies_behind_the_text(self):
        done = self.run_with("scans_beyond")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("part.nc:2:1: error: BadSyntax broke the contract: its scan() returned an end after the text",
                      done.stderr)
        self.assertIn('"Z":3', done.stdout)  # the words after it are there

    def test_a_throwing_syntax_does_not_end_the_run(self):
        done = self.run_with("throws_in_build")
        self.assertIn('"Line":3', done.stdout)

    def test_the_checked_table_finds_broken_contracts(self):
        for plugin in CHECKED:
            with self.subTest(plugin):
                done = self.run_with(plugin, "--checked")
                self.assertEqual(done.returncode, 3, done.stderr)
                self.assertIn("[IG-0402]", done.stderr)
                self.assertIn("BadSyntax", done.stderr)

    def test_a_syntax_that_acts_where_nothing_wakes_it_is_named(self):
        """The syntax wakes on X, so it is not called in line 1; the fault shows only when all syntaxes are called."""
        self.assertNotIn("IG-0240", self.run_with("acts_unasked", "--checked").stderr)
        done = self.run_with("acts_unasked", "--checked", "--call-all")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("part.nc:1:1: error: BadSyntax acts in this block", done.stderr)
        self.assertIn("[IG-0240]", done.stderr)

    def test_a_value_of_another_type_does_no_harm(self):
        """The fast table accepts it: the frame stays, and the tool moves as without the plugin."""
        sound = self.run_it("run", self.program, "-d", "iso").stdout
        for plugin in ("sets_a_frame_as_number", "sets_a_text_as_number"):
            with self.subTest(plugin):
                done = self.run_with(plugin)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(done.stdout, sound)

    def test_a_nonsense_status_of_create_does_not_start_or_does_no_harm(self):
        done = self.run_with("create_nonsense")
        self.assertIn(done.returncode, (0, 2), done.stderr)

    def test_crashes_outside_a_block_name_the_plugin(self):
        for plugin in ("crashes_at_load", "crashes_in_entry", "entry_is_data"):
            with self.subTest(plugin):
                for done in (self.doctor(OPTIONS.plugins / plugin), self.run_with(plugin)):
                    self.assertEqual(done.returncode, 3, done.stderr)
                    self.assertIn("internal fault: segmentation fault while loading the plugin", done.stderr)
                    self.assertIn(f"{plugin}.so", done.stderr)
        done = self.run_with("create_crashes")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("internal fault: segmentation fault", done.stderr)

    def test_another_minor_version_is_welcome(self):
        # Under sanitizers those of one plugin: all take 40 s there.
        pages = ["--all"] if FACTOR >= 1 else sorted(SOURCE.glob("plugins/kinematics/**/*.md"))
        self.assertTrue(pages)
        for plugin in ("newer_minor", "older_minor"):
            with self.subTest(plugin):
                done = self.doctor(OPTIONS.plugins / plugin)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assertIn(f"{plugin} 1.0.0: 1 syntaxes", done.stdout)
                self.assertEqual(self.run_with(plugin).returncode, 0)
                self.assertEqual(self.run_it("case", *pages, "--plugins", OPTIONS.plugins / plugin).returncode, 0)

    def test_leaking_symbols_are_a_warning(self):
        done = self.doctor(OPTIONS.plugins / "exports_too_much")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        line = next(line for line in done.stdout.splitlines() if "[IG-0309]" in line)
        self.assertIn("exports 1 symbols besides ig_plugin_v1, helper_of_everyone", line)
        self.assertEqual(self.run_with("exports_too_much").returncode, 0)

    def test_a_file_of_another_name_is_refused(self):
        shutil.copy(OPTIONS.plugins / "newer_minor" / "newer_minor.so", self.path / "renamed.so")
        done = self.doctor(self.path)
        self.assertEqual(done.returncode, 1)
        self.assertIn("its name is 'newer_minor', so the file must be too [IG-0305]", done.stdout)


if __name__ == "__main__":
    main()
