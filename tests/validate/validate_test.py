#!/usr/bin/env python3
"""`isogloss validate`: the plugins of this project keep the contract, and each check finds the plugin that has its fault.

  validate_test.py --isogloss PATH --faulty FOLDER
  validate_test.py --isogloss PATH --own PLUGIN
"""
import argparse
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import budgeted  # noqa: E402: it lies in another folder

OPTIONS = None

# The fault of a plugin: the check that finds it, and words of what it tells.
FAULTS = {
    "crash_at_load": ("loads", "while loading the plugin"),
    "other_answer": ("loads", "two calls of the entry give two answers"),
    "code": ("descriptor", "'no code' is not a prefix and number"),
    "exports": ("exports", "of_everyone: is exported"),
    "stays": ("unloads", "stays in memory"),
    "slow_load": ("load-time", "more than 50 ms"),
    "no_summary": ("documented", "FaultySyntax: has no summary"),
    "prefix": ("prefix", "the prefix ISO belongs to plugin "),
    "bad_case": ("cases", "X becomes the feed: the case does not hold"),
    "undeclared": ("declarations", "it writes Feedrate.FeedrateValue, which it does not declare"),
    "never_written": ("unused-fields", "no case writes or takes these fields, which it declares: ProgramXyz.X"),
    "lies": ("unchanged", "its build() says unchanged, but the block changed"),
    "status": ("unchanged", "its build() returned the status 77"),
    "empty": ("empty-block", "segmentation fault in FaultySyntax of plugin empty, at work in build()"),
    "hang": ("empty-block", "in FaultySyntax of plugin hang, at work in build()"),
    "memory": ("empty-block", "segmentation fault in FaultySyntax of plugin memory"),
    "absent": ("absent-fields", "without Parsing.Y: segmentation fault"),
    "huge_text": ("extreme-values", "where Comment.Text is a text of 1 MiB: "),
    "nan": ("extreme-values", "where Parsing.X is nan: segmentation fault"),
    "option_bounds": ("options", 'FaultySyntax, length="10": '),
    "global_count": ("same-result", "a new chain gives another result for the same block"),
    "keeps": ("restart", "the second run gives another result"),
    "other_chain": ("two-chains", "another chain at work changes the result"),
    "shared_scratch": ("threads", "a chain on another thread changes the result"),
    "service": ("without-services", "FaultySyntax without services: segmentation fault"),
    "newer_call": ("older-host", "with a host of minor version 0: segmentation fault"),
    "exact_size": ("newer-host", "with a host of minor version"),
    "random": ("random-blocks", "it crashes, does not return, or ends the process"),
    "random_lie": ("random-blocks", "its build() says unchanged, but the block changed"),
    "slow": ("time", "more than the budget of 10000 ns"),
    "leaves_process": ("empty-block", "segmentation fault in FaultySyntax of plugin leaves_process"),
    "prints": ("empty-block", "segmentation fault in FaultySyntax of plugin prints"),
    "ended_by_signal": ("empty-block", "the process was ended by signal 10"),
    "never_read": ("unread-fields", "no block makes it read these fields, which it declares: ProgramXyz.Y"),
    "reads_behind_text": ("texts", "no byte behind a text or after the call may be read: segmentation fault"),
    "reads_behind_source": ("texts", "no byte behind a text or after the call may be read: segmentation fault"),
    "keeps_text": ("texts", "no byte behind a text or after the call may be read: segmentation fault"),
    "rare_option": ("options", "it writes ProgramXyz.Z, which it does not declare"),
    "unknown_diagnostic": ("declarations", "it reports a diagnostic that is not in its plugin's table"),
    "leaks": ("memory", "memory grows without end: by "),
    "leaks_little": ("memory", "memory grows without end: by "),
    "leaks_at_destroy": ("memory", "a chain that is destroyed leaves "),
    "allocates": ("allocations", "each build allocates 1 time more"),
    "waits_rarely": ("waits", "its build waits"),
    "keeps_error": ("restart", "the second run gives another result"),
    "changes_locale": ("process-state", "it changes the locale"),
    "changes_rounding": ("process-state", "it changes the rounding mode"),
    "changes_signal": ("process-state", "it changes the handler of signal 10: none was "),
    "leaves_file": ("leaves-nothing", "files that it opened are left open"),
    "leaves_thread": ("leaves-nothing", "of its threads go on after its chains are destroyed"),
    "keeps_block": ("borrowed", "with the block of an earlier call, which was only lent"),
    "keeps_functions": ("borrowed", "it uses the table of functions of an earlier call"),
    "keeps_ids": ("borrowed", "what an earlier call lent (block, functions, ids, texts) may not be used: segmentation"),
    "keeps_option": ("borrowed", "it uses the table of functions of an earlier call"),
    "reads_comma": ("elsewhere", "its result is another one where numbers are written with a decimal comma"),
    "writes_comma": ("elsewhere", "its result is another one where numbers are written with a decimal comma"),
    "reads_clock": ("elsewhere", "its result is another one at another time"),
    "uses_address": ("elsewhere", "its result is another one in another process, with other addresses and other bytes"),
    "uses_old_memory": ("elsewhere", "its result is another one in another process, with other addresses and other bytes"),
    "reads_variable": ("elsewhere", "its result is another one with another working folder and other environment"),
    "prints_at_load": ("input-output", "it writes to standard output, where the data of the command goes: faulty 1.0"),
    "prints_to_error": ("input-output", "it calls fprintf of the system"),
    "reads_file": ("input-output", "it calls fopen of the system"),
    "writes_at_create": ("input-output", "its create() or restart() calls fopen (for writing) of the system"),
    "ends_badly": ("end", "it crashes or does not return when the process ends"),
    "crash_at_close": ("loads", "closing the library: segmentation fault"),
    "not_finite": ("finite-results", "it gives Feedrate.FeedrateValue a value that is not a number"),
    "no_reason": ("options", "could not be created: its create() gives no reason"),
    "many_at_once": ("declarations", "it asks for 40 fields at once, while the answer has 32 bits"),
    "counts_quietly": ("statics", "it writes to a static variable, which all chains share; nm -C names it near 0x"),
    "counts_in_heap": ("statics", "it changes memory to which a static variable points"),
    "counts_in_thread": ("statics", "it changes a variable of the thread"),
    "spins": ("statics", "it writes to a static variable, which all chains share"),
    "locks": ("input-output", "it calls pthread_mutex_lock of the system"),
    "yields": ("input-output", "it calls sched_yield of the system"),
    "draws": ("input-output", "it calls getrandom of the system"),
    "asks_time": ("input-output", "it calls time of the system"),
    "reads_relative": ("input-output", "calls a function for a file in the working folder"),
    "scans_behind": ("scan", "no byte behind the text may be read: segmentation fault in PartSyntax"),
    "scans_back": ("scan", "its scan() returned a position before the one at which it was asked"),
    "scans_undeclared": ("scan", "it writes Parsing.Y, which it does not declare"),
    "scans_into_table": ("scan", "segmentation fault in PartSyntax of plugin scans_into_table, at work in scan()"),
    "columns_beyond": ("scan", "it gives a word the columns 0 to "),
    "leaks_in_scan": ("memory", "memory grows without end: by "),
    "leaks_at_restart": ("memory", "bytes in many runs; restart() must free"),
    "leaks_with_option": ("memory", "a chain that is destroyed leaves "),
    "keeps_all": ("memory", "bytes in many blocks"),
    "reads_absent": ("absent-answers", "its result depends on what *out holds after an answer of 0"),
    "says_changed": ("changed", "its build() says changed, but it wrote, took and reported nothing"),
    "changes_mxcsr": ("random-blocks", "after its random blocks: it changes the control word of the SSE unit"),
    "sets_timer": ("random-blocks", "after its random blocks: it changes the timer of the process's time"),
    "changes_signal_stack": ("process-state", "it changes the stack for signals"),
    "option_with_word": ("options", 'width="wide"'),
    "option_with_text": ("options", 'width="wide", a block of text alone: segmentation fault'),
    "reads_setting": ("options", 'each setting is "99999999999999999999": segmentation fault'),
    "cut_character": ("texts", "no byte behind a text or after the call may be read: segmentation fault"),
    "null_in_text": ("extreme-values", "segmentation fault in PartSyntax of plugin null_in_text"),
    "forgets_partly": ("restart", "the second run gives another result"),
    "keeps_first_ids": ("two-chains", "with other options and other ids of fields"),
    "keeps_first_option": ("two-chains", "with other options and other ids of fields"),
    "wrong_boolean": ("declarations", "it gives ToolChange.IsChange the value 171, while it is 0 or 1"),
    "wrong_kind": ("declarations", "it calls a function of transforms with Feedrate.FeedrateValue, which is no transform"),
    "wrong_record": ("declarations", "it calls a function of records with fields that are not of one list"),
    "looks_ahead": ("declarations", "it asks for the block 3 ahead, while it declares a look-ahead of 0"),
    "reports_beyond": ("declarations", "it gives PART-0001 the columns 0 to 100000 of a text of 0 bytes"),
    "wrong_option": ("options", "it calls option_number() for the option 'width', which is of another type"),
    "undeclared_service": ("options", "it asks for the service isogloss.work-offset/1, which it does not declare"),
    "reads_any_variable": ("elsewhere", "its result is another one with another working folder and other environment"),
    "other_default": ("documented", "the page says that the default of option 'length' is 1, the declaration has 2"),
    "other_range": ("documented", "the page says that option 'length' goes from 0 to 10, the declaration has 0 to 20"),
    "unnamed_option": ("documented", "the page does not name option 'mirrored'"),
    "lifeless_field": ("documented", "field 'Part.Level' is of no standard section and has no life"),
    "import_without_page": ("documented", "PartFile: has no page with a case"),
    "table_trusts_end": ("tables", "PartTable, its defaults, service isogloss.motion/1"),
    "table_knows_all": ("tables", "its service isogloss.motion/1 answers for a name that does not exist"),
    "table_divides": ("tables", "value that is not a number"),
    "table_gives_no_reason": ("tables", 'scale="100": '),
    "table_trusts_key": ("tables", "PartTable, a row 'KKKKKKKKKKKKKKKKKKKK'"),
    "import_recognises_empty": ("importers", "its recognise() answers 10 for an empty file"),
    "import_trusts_end": ("importers", "no byte behind a text may be read: segmentation fault"),
    "import_surer": ("importers", "its recognise() answers 1000, more than 100"),
    "import_gives_no_reason": ("importers", "its read() fails and gives no reason"),
    "import_trusts_line": ("importers", "PartFile, the file of its case 1, damaged in the way "),
    "import_ignores_bounds": ("importers", "which the table refuses"),
    "import_places_beyond": ("importers", "it gives the place 10"),
    "import_rereads": ("importers", "times as long for 4 times the text"),
    "counts_beyond": ("overruns", " bytes before a piece of "),
    "counts_rarely": ("statics", "it writes to a static variable, which all chains share"),
    "makes_names": ("memory", " new names, which the host keeps, in 400 blocks that differ in their numbers"),
    "option_trusts_end": ("options", "segmentation fault in PartSyntax of plugin option_trusts_end, at work in create()"),
    "scan_gives_word": ("scan", "its scan() gave a word and returned the position at which it was asked"),
    "scan_keeps_number": ("scan-ahead", "scanned ahead, and built by another instance, it gives"),
    "scan_remembers": ("scan-ahead", "scanned ahead, and built by another instance, it gives"),
    "scan_reads_rest": ("scan", "reads the rest of the text again from each byte"),
    "table_text_on_stack": ("tables", "the text that its row_fault() returns is gone before the next call"),
    "asleep": ("declarations", "no field wakes it, so its build() is never called"),
    "lacks_argument": ("random-blocks", "it gives 0 of the 1 arguments of FLT-0001"),
    "slow_rarely": ("time", "more than the budget of 10000 ns"),
    "sets_variable": ("process-state", "it changes the environment variable FAULTY: 1 was not set"),
    "blocks_signal": ("process-state", "it changes the signals that are held back: 12 was none"),
    "leaks_pages": ("memory", "memory grows without end: by "),
    "leaves_child": ("leaves-nothing", "a process that it started is left"),
}
# What a busy machine may make fail, and statics: whether a number in a variable looks like an address depends on where the
# system has put the heap this time.
TIMES = {"load-time", "time", "statics"}
LIMITS = ["--call-limit", "1", "--memory-limit", "512"]


def faulty(name):
    return OPTIONS.faulty / name / f"{name}.so"


class Case(unittest.TestCase):
    def run_it(self, *arguments):
        environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")}
        return subprocess.run([OPTIONS.isogloss, "validate", *map(str, arguments)], capture_output=True, text=True,
                              timeout=1800, check=False, env=environment)

    def checks(self, *arguments):
        done = self.run_it(*arguments, "--json")
        self.assertEqual(done.stderr, "")
        return done.returncode, json.loads(done.stdout)["Plugins"][0]["Checks"]


class Own(Case):
    def test_a_plugin_of_this_project_keeps_the_contract(self):
        plugin = OPTIONS.isogloss.parent / "plugins" / f"{OPTIONS.own}.so"
        _, checks = self.checks(plugin, "--blocks", budgeted(10_000))
        failed = [c for c in checks if c["Level"] != "note" and c["Result"] != "held"]
        self.assertEqual([c for c in failed if c["Name"] not in TIMES], [])
        # A slow or busy machine makes a check of times fail: it may take three times the budget of the default.
        for check in failed:
            self.assertTrue(any(self.run_it(plugin, "--only", check["Name"], "--budget", 30_000, "--strict").returncode == 0
                                for _ in range(5)), check)


class Validate(Case):
    def test_each_check_finds_its_fault(self):
        listed = {line.split()[0]: line.split()[1] for line in self.run_it("--list").stdout.splitlines()}
        self.assertEqual({check for check, _ in FAULTS.values()}, set(listed), "a check without a faulty plugin")
        for fault, (check, text) in FAULTS.items():
            with self.subTest(fault):
                # A race between threads is seen when the machine lets both run at once, so it has several tries.
                for _ in range(10 if check == "threads" else 1):
                    # A busy machine takes long for what grows with the square of the text, and is not to call it a hang.
                    limits = ["--call-limit", "10", *LIMITS[2:]] if fault == "scan_reads_rest" else LIMITS
                    blocks = ["--blocks", "100"] if check == "random-blocks" else []
                    status, checks = self.checks(faulty(fault), "--only", check, *limits, *blocks)
                    found = [c for c in checks if c["Name"] == check][0]
                    if found["Result"] == "failed":
                        break
                self.assertEqual(found["Result"], "failed", checks)
                told = "\n".join(f"{f['Where']}: {f['What']}" for f in found["Findings"])
                self.assertIn(text, told)
                self.assertEqual(found["Level"], listed[check])
                self.assertEqual(status, 1 if listed[check] == "must" else 0)
                if listed[check] == "should":
                    self.assertEqual(self.run_it(faulty(fault), "--only", check, "--strict").returncode, 1)

    def test_a_sound_plugin_passes_every_check(self):
        done = self.run_it(faulty("sound"), "--strict", "--blocks", 5000)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn("FAILED", done.stdout)
        self.assertIn("44 checks held; failed: 0 must, 0 should, 0 note", done.stdout)
        for name in ("sound_parts", "scan_sound"):
            done = self.run_it(faulty(name), "--strict", "--blocks", 5000)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_what_is_right_is_no_fault(self):
        """A reason for a value that is none or for an old host, and a thread that destroy() ends."""
        for name, checks in (("fails_over_nan", ("extreme-values",)), ("fails_by_report", ("extreme-values",)), ("refuses_old_host", ("older-host",)),
                             ("joins_thread", ("input-output", "leaves-nothing", "threads"))):
            for check in checks:
                _, found = self.checks(faulty(name), "--only", check)
                self.assertEqual(found[0]["Result"], "held", (name, found))

    def test_a_plugin_that_stops_itself_costs_no_time(self):
        begin = time.monotonic()
        status, checks = self.checks(faulty("stops_itself"), "--only", "absent-fields")
        self.assertLess(time.monotonic() - begin, 30)
        self.assertEqual(status, 1)
        self.assertIn("the process stopped itself", checks[0]["Findings"][0]["What"])

    def test_a_check_that_had_nothing_to_look_at_does_not_say_held(self):
        status, checks = self.checks(faulty("cannot_be_created"), "--only", "options", "--only", "empty-block",
                                     "--only", "exports")
        self.assertEqual(status, 1)
        self.assertEqual({c["Name"]: c["Result"] for c in checks},
                         {"options": "failed", "empty-block": "skipped", "exports": "held"})
        self.assertIn("no syntax of the plugin can be linked and created", [c for c in checks if c["Result"] == "skipped"][0]["Reason"])

    def test_a_plugin_that_forgets_at_a_restart_passes(self):
        status, checks = self.checks(faulty("forgets"), "--only", "restart")
        self.assertEqual((status, checks[0]["Result"]), (0, "held"))

    def test_a_random_block_is_shrunk_and_comes_again(self):
        """X above 2 and Y below -2 fail together, so the smallest block has both words and nothing else."""
        for seed in (1, 7):
            first, again = (self.run_it(faulty("random"), "--only", "random-blocks", "--seed", seed, "--blocks", 1000).stdout
                            for _ in range(2))
            self.assertEqual(first, again)
            block = json.loads(re.search(r"the smallest block that fails: (.*)", first)[1])
            self.assertEqual(set(block), {"Parsing"})
            self.assertEqual(set(block["Parsing"]), {"X", "Y"})
            self.assertIn(f"--only random-blocks --seed {seed} --blocks 1000", first)

    def test_pages_of_a_folder_replace_those_in_the_plugin(self):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "faulty_syntax.md"
            page.write_text("# FaultySyntax\n\nText.\n\n## A case of the folder\n\n#BeforeBuild:\n```json\n"
                            '{"Parsing": {"X": 5}}\n```\n#AfterBuild:\n```json\n{}\n```\n')
            done = self.run_it(faulty("bad_case"), "--only", "cases", "--pages", folder)
        self.assertEqual(done.returncode, 1)
        self.assertIn("A case of the folder: the case does not hold", done.stdout)
        self.assertNotIn("X becomes the feed", done.stdout)

    def test_a_plugin_that_does_not_load_is_not_looked_at_further(self):
        status, checks = self.checks(faulty("crash_at_load"))
        self.assertEqual(status, 1)
        self.assertEqual([c["Result"] for c in checks], ["failed"] + ["skipped"] * (len(checks) - 1))

    def test_junit_counts_what_failed(self):
        done = self.run_it(faulty("lies"), "--format", "junit", "--only", "unchanged", "--only", "exports")
        suite = xml.etree.ElementTree.fromstring(done.stdout).find("testsuite")
        self.assertEqual((suite.get("tests"), suite.get("failures")), ("2", "1"))
        self.assertIn("says unchanged", suite.find("testcase[@name='unchanged']/failure").get("message"))
        self.assertIsNone(suite.find("testcase[@name='exports']/failure"))

    def test_sarif_has_a_rule_for_each_check_and_a_result_for_each_finding(self):
        done = self.run_it(faulty("lies"), faulty("no_summary"), "--format", "sarif", "--only", "unchanged", "--only",
                           "documented")
        self.assertEqual(done.returncode, 1)
        log = json.loads(done.stdout)
        self.assertEqual((log["version"], log["$schema"]), ("2.1.0", "https://json.schemastore.org/sarif-2.1.0.json"))
        run, = log["runs"]
        driver = run["tool"]["driver"]
        self.assertTrue(driver["name"] and driver["version"])
        self.assertEqual([rule["id"] for rule in driver["rules"]], self.listed())
        for rule in driver["rules"]:
            self.assertTrue(rule["shortDescription"]["text"] and rule["help"]["text"].endswith("."), rule)
        self.assertEqual(run["invocations"], [{"executionSuccessful": True}])
        self.assertEqual({r["ruleId"] for r in run["results"]}, {"unchanged", "documented"})
        for result in run["results"]:
            rule = driver["rules"][result["ruleIndex"]]
            self.assertEqual((rule["id"], rule["defaultConfiguration"]["level"]), (result["ruleId"], result["level"]))
            self.assertEqual(result["level"], "error" if result["ruleId"] == "unchanged" else "warning")
            self.assertTrue(result["message"]["text"])
            place, = result["locations"]
            fault = "lies" if result["ruleId"] == "unchanged" else "no_summary"
            self.assertEqual(place["physicalLocation"]["artifactLocation"]["uri"], faulty(fault).as_uri())
            self.assertIn("FaultySyntax", place["logicalLocations"][0]["fullyQualifiedName"])
        self.assertEqual(json.loads(self.run_it(faulty("sound"), "--only", "loads", "--format", "sarif").stdout)["runs"][0]
                         ["results"], [])
        refused = json.loads(self.run_it(faulty("crash_at_load"), "--format", "sarif").stdout)["runs"][0]
        self.assertEqual(refused["invocations"], [{"executionSuccessful": False}], "checks were skipped")
        with tempfile.TemporaryDirectory() as folder:
            odd = pathlib.Path(folder) / "100% ä"
            odd.mkdir()
            (odd / "lies.so").write_bytes(faulty("lies").read_bytes())
            done = self.run_it(odd / "lies.so", "--only", "unchanged", "--format", "sarif")
            place = json.loads(done.stdout)["runs"][0]["results"][0]["locations"][0]["physicalLocation"]
            self.assertEqual(place["artifactLocation"]["uri"], (odd / "lies.so").as_uri())

    def listed(self, *arguments):
        return [line.split()[0] for line in self.run_it("--list", *arguments).stdout.splitlines()]

    def test_list_takes_checks_and_forms(self):
        self.assertEqual(self.listed("--only", "texts", "--only", "loads"), ["loads", "texts"])
        checks = json.loads(self.run_it("--list", "--json").stdout)["Checks"]
        self.assertEqual([check["Name"] for check in checks], self.listed())
        self.assertTrue(all(check["Level"] and check["Summary"] and check["Help"] for check in checks))

    def test_a_missing_file_does_not_keep_the_others_from_being_looked_at(self):
        done = self.run_it(faulty("sound"), "no-such.so", faulty("lies"), "--only", "unchanged", "--json")
        self.assertEqual(done.returncode, 2)
        self.assertIn("no-such.so", done.stderr)
        self.assertEqual([p["Checks"][0]["Result"] for p in json.loads(done.stdout)["Plugins"]], ["held", "failed"])

    def test_a_file_that_is_no_library_says_why(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "acme.so"
            for content, why in ((b"", "the file is empty"), (b"notes\n", "the file does not begin as an ELF file does"),
                                 (b"\x7fELF" + bytes(200), "")):
                path.write_bytes(content)
                done = self.run_it(path)
                self.assertEqual(done.returncode, 1)
                self.assertIn("not a shared library (" + why, done.stdout)
                self.assertNotIn("basic_ios", done.stdout)

    def test_random_blocks_say_how_many_there_were(self):
        done = self.run_it(faulty("sound"), "--only", "random-blocks", "--blocks", 300, "--seed", 5)
        self.assertIn("      300 random blocks of seed 5\n", done.stdout)
        _, checks = self.checks(faulty("sound"), "--only", "random-blocks", "--blocks", 10**9, "--random-limit", 1)
        self.assertRegex(checks[0]["Remarks"][0], r"^\d+ of 1000000000 random blocks of seed 1: the 1 s of --random-limit")
        done = self.run_it(faulty("sound"), "--only", "random-blocks", "--blocks", 300, "--format", "junit")
        suite = xml.etree.ElementTree.fromstring(done.stdout).find("testsuite")
        self.assertEqual(suite.get("failures"), "0")
        self.assertIn("300 random blocks", suite.find("testcase/system-out").text)

    def test_the_time_limit_holds_for_a_process_that_leaves_its_group(self):
        done = self.run_it(faulty("leaves_group"), "--only", "empty-block", "--time-limit", 3)
        self.assertEqual(done.returncode, 1)
        self.assertIn("the check took longer than 3 s", done.stdout)

    def test_findings_beyond_the_first_twenty_are_counted(self):
        done = self.run_it(faulty("many_exports"), "--only", "exports")
        self.assertEqual(done.stdout.count("is exported, so"), 20)
        self.assertIn("\n      and 5 more\n", done.stdout)
        _, checks = self.checks(faulty("many_exports"), "--only", "exports")
        self.assertEqual(checks[0]["FurtherFindings"], 5)

    def test_a_time_limit_may_be_of_any_size(self):
        done = self.run_it(faulty("sound"), "--only", "empty-block", "--time-limit", 2**32 - 1)
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_checks_at_once_find_what_they_find_one_by_one(self):
        for name in ("sound", "empty", "many_exports"):
            def found(jobs):
                status, checks = self.checks(faulty(name), "--blocks", 200, "--jobs", jobs)
                return status, [{k: v for k, v in check.items() if k != "Seconds"} for check in checks]
            with self.subTest(plugin=name):
                self.assertEqual(found(5), found(1))

    def test_checks_run_at_once_and_those_of_times_alone(self):
        """The checks of this plugin wait, and each has a process that watches over it."""
        for checks, watchers in ((["empty-block", "absent-fields", "extreme-values"], 2), (["waits", "time"], 1)):
            only = [word for check in checks for word in ("--only", check)]
            with self.subTest(checks=checks), \
                 subprocess.Popen([OPTIONS.isogloss, "validate", faulty("leaves_group"), "-j", "2", *only],
                                  stdout=subprocess.DEVNULL) as command:
                children = pathlib.Path(f"/proc/{command.pid}/task/{command.pid}/children")
                time.sleep(2)
                found = children.read_text().split()
                command.kill()
                self.assertEqual(len(found), watchers)

    def test_a_check_whose_watcher_is_killed_is_told(self):
        with subprocess.Popen([OPTIONS.isogloss, "validate", faulty("leaves_group"), "-j", "2", "--only", "empty-block",
                               "--only", "absent-fields", "--json"], stdout=subprocess.PIPE, text=True) as command:
            children = pathlib.Path(f"/proc/{command.pid}/task/{command.pid}/children")
            time.sleep(2)
            for watcher in children.read_text().split():
                os.kill(int(watcher), signal.SIGKILL)
            checks = json.loads(command.communicate(timeout=20)[0])["Plugins"][0]["Checks"]
        self.assertEqual([f["What"] for c in checks for f in c["Findings"]],
                         ["the process that watched over the check has ended"] * 2)

    def test_a_check_ends_with_the_command(self):
        for checks in (["empty-block"], ["empty-block", "absent-fields"]):  # one, and two at once
            with self.subTest(checks=checks):
                self.check_ends_with_the_command([word for check in checks for word in ("--only", check)])

    def check_ends_with_the_command(self, arguments):
        """The check has the command's input open, so the pipe breaks when nobody is left."""
        with subprocess.Popen([OPTIONS.isogloss, "validate", faulty("leaves_group"), "-j", "2", *arguments],
                              stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, bufsize=0) as command:
            time.sleep(2)
            self.assertIsNone(command.poll())
            command.kill()
            command.wait()
            end = time.monotonic() + 20
            with self.assertRaises(BrokenPipeError):
                while time.monotonic() < end:
                    command.stdin.write(b"x")
                    time.sleep(0.1)

    def test_in_process_a_crash_is_the_command_s_own(self):
        self.assertEqual(self.run_it(faulty("sound"), "--in-process", "--strict").returncode, 0)
        done = self.run_it(faulty("empty"), "--in-process", "--only", "empty-block")
        self.assertEqual(done.returncode, 3)
        self.assertIn("segmentation fault in FaultySyntax of plugin empty", done.stderr)

    def test_wrong_usage_cannot_start(self):
        for arguments, text in (([], "name the file of a plugin"), (["no-such.so"], "there is no such file"),
                                ([OPTIONS.faulty], "it is no file"), (["--list", faulty("sound")], "leave "),
                                (["--list", "--format", "sarif"], "--list writes text or JSON"),
                                (["--list", "--only", "unchange"], "did you mean unchanged?"),
                                ([faulty("sound"), "--only", "unchange"], "did you mean unchanged?"),
                                ([faulty("sound"), "-d", "no-such-dialect"], "IG-0101")):
            done = self.run_it(*arguments)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn(text, done.stderr)
        for number, status in (("010", 0), ("18446744073709551615", 0), ("18446744073709551616", 2), ("0x10", 2)):
            done = self.run_it(faulty("sound"), "--only", "loads", "--seed", number, "--json")
            self.assertEqual(done.returncode, status, number)
            if status == 0:
                self.assertEqual(json.loads(done.stdout)["Seed"], int(number))
        self.assertIn("[IG-0155]", self.run_it(faulty("sound"), "--only", "unchange").stderr)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--faulty", type=pathlib.Path)
    parser.add_argument("--own", help="this plugin of the project alone")
    OPTIONS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest], defaultTest="Own" if OPTIONS.own else "Validate")
