#!/usr/bin/env python3
"""`isogloss batch`: many programs, each in a process of its own.

  batch_test.py --isogloss PATH --bad-plugins FOLDER [--seconds N] [unittest's own options]
"""
import argparse
import csv
import fcntl
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree

HERE = pathlib.Path(__file__).resolve().parent
PROGRAMS = HERE.parent / "programs"
OPTIONS = None
RESULTS = ("results.jsonl", "results.csv", "results.xml", "overview.html")
LONG = "#1=0\nWHILE[#1LT600000]DO1\n#1=#1+1\n" + "#2=#1*2\n" * 12 + "END1\n"  # a second or more
GOOD = "G21 G90 G94 G17\nG0 X10. Y5. Z2.\nG1 Z-1. F100.\nX20.\nM30\n"
BAD = "G21 G90\nG1 X10. F100.\nG999 X1.\nM30\n"


def command(*arguments, cwd=None, given=None):
    environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")}
    return subprocess.run([OPTIONS.isogloss, *map(str, arguments)], capture_output=True, text=True, cwd=cwd, input=given,
                          timeout=20 * OPTIONS.seconds, check=False, env=environment, errors="replace")


def children_of(process):
    out = []
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            if int(stat.read_text().rsplit(")", 1)[1].split()[1]) == process:
                out.append(stat.parent.name)
        except OSError:  # it is gone
            pass
    return out


class Batch(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        self.archive = self.path / "archive"
        self.archive.mkdir()

    def write(self, name, text):
        file = self.archive / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(text if isinstance(text, bytes) else text.encode())
        return file

    def batch(self, *more, out="out", status=0, dialect=("-d", "fanuc"), places=("archive",)):
        done = command("batch", *places, *dialect, "-o", out, *more, cwd=self.path)
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertEqual(done.stdout, "")
        return done

    def results(self, out="out"):
        lines = (self.path / out / "results.jsonl").read_text().splitlines()
        return {pathlib.Path(r["Program"]).relative_to("archive").as_posix(): r for r in map(json.loads, lines)}

    def journal(self, out="out"):
        """The programs whose results were appended, in that order."""
        files = sorted((self.path / out / "journal").glob("*.jsonl"), key=lambda f: f.stat().st_mtime_ns)
        return [json.loads(line)["Program"] for file in files for line in file.read_text().splitlines()]

    def archive_of(self, count):
        for number in range(count):
            self.write(f"{number % 3}/O{number:04}.nc", GOOD.replace("X20.", f"X{number}."))

    def test_a_line_for_each_program_in_four_files(self):
        self.write("b.nc", GOOD)
        self.write("a.nc", BAD)
        self.write("sub/c, \"odd\" <name>.nc", GOOD)
        done = self.batch(status=1)
        self.assertIn("3 programs: 2 ok, 1 with errors", done.stderr)
        results = self.results()
        self.assertEqual(list(results), ["a.nc", "b.nc", "sub/c, \"odd\" <name>.nc"])
        single = json.loads(command("run", "archive/b.nc", "-d", "fanuc", "--summary", "--json", cwd=self.path).stdout)
        self.assertEqual({**single, **results["b.nc"]}, {"Isogloss": 1, "Program": "archive/b.nc", "Status": "ok", **single})
        self.assertEqual(results["a.nc"]["Status"], "errors")
        self.assertEqual(results["a.nc"]["First"]["Line"], 3)
        with (self.path / "out/results.csv").open(newline="") as table:
            rows = list(csv.DictReader(table))
        self.assertEqual([r["Status"] for r in rows], ["errors", "ok", "ok"])
        self.assertEqual(rows[2]["Program"], "archive/sub/c, \"odd\" <name>.nc")
        self.assertEqual(float(rows[1]["FeedLength_mm"]), single["FeedLength_mm"])
        self.assertRegex(rows[0]["First"], r"^line 3: .* \[[A-Z]+-\d+\]$")
        suite = xml.etree.ElementTree.parse(self.path / "out/results.xml").getroot()[0]
        self.assertEqual((suite.get("tests"), suite.get("failures"), suite.get("errors")), ("3", "1", "0"))
        self.assertEqual([len(case) for case in suite], [1, 0, 0])
        page = (self.path / "out/overview.html").read_text()
        data = page.split('id="data">')[1].split("</script>")[0]
        self.assertNotIn("<", data)
        self.assertEqual([row[0] for row in json.loads(data)], [r["Program"] for r in rows])

    def test_the_number_of_processes_changes_no_byte(self):
        self.archive_of(12)
        self.write("bad.nc", BAD)
        self.batch("-j1", out="one", status=1)
        self.batch("-j5", out="five", status=1)
        for name in RESULTS:
            self.assertEqual((self.path / "one" / name).read_bytes(), (self.path / "five" / name).read_bytes(), name)

    def test_parts_merge_to_the_bytes_of_one_process(self):
        self.archive_of(14)
        self.batch(out="whole")
        parts = []
        for number in (1, 2, 3):
            before = len(self.journal()) if number > 1 else 0
            self.batch("--shard", f"{number}/3")
            parts.append(len(self.journal()) - before)
            if number < 3:
                self.assertIn("[IG-0673]", self.batch("--merge", status=2).stderr)
                self.assertFalse((self.path / "out/results.csv").exists())
        self.assertEqual(sum(parts), 14)
        self.assertGreater(min(parts), 0)
        self.batch("--shard", "2/3")  # requeued: it repeats nothing
        self.assertEqual(len(self.journal()), 14)
        self.batch("--merge")
        for name in RESULTS:
            self.assertEqual((self.path / "out" / name).read_bytes(), (self.path / "whole" / name).read_bytes(), name)

    def test_a_killed_batch_goes_on(self):
        self.archive_of(120)
        self.batch(out="whole")
        process = subprocess.Popen([OPTIONS.isogloss, "batch", "archive", "-d", "fanuc", "-o", "out", "-j2"], cwd=self.path,
                                   stderr=subprocess.DEVNULL)
        deadline = time.monotonic() + 2 * OPTIONS.seconds
        while not (self.path / "out/journal").exists() or len(self.journal()) < 5:
            self.assertLess(time.monotonic(), deadline)
            self.assertIsNone(process.poll())
            time.sleep(0.002)
        process.kill()
        process.wait()
        done = len(self.journal())
        self.assertLess(done, 120)
        self.assertFalse((self.path / "out/results.jsonl").exists())
        [file] = (self.path / "out/journal").iterdir()
        file.write_bytes(file.read_bytes() + b'{"Program":"archive/0/O00')  # what a kill may leave
        said = self.batch().stderr
        self.assertIn(f"{done} of 120 programs were finished before", said)
        self.assertIn("[IG-0672]", said)
        self.assertEqual(len(json.loads("[" + ",".join(
            line for f in (self.path / "out/journal").glob("*.jsonl") for line in f.read_text().splitlines()
            if line.endswith("}")) + "]")), 120)
        for name in RESULTS:
            self.assertEqual((self.path / "out" / name).read_bytes(), (self.path / "whole" / name).read_bytes(), name)

    def test_a_signal_ends_all_processes(self):
        for number in range(3):
            self.write(f"{number}.nc", "N1 G1 X1. F100.\nX0\nGOTO 1\nM30\n")
        process = subprocess.Popen([OPTIONS.isogloss, "batch", "archive", "-d", "fanuc", "-o", "out", "-j3",
                                    "--max-jumps", "999999999", "--max-loop-blocks", "99999999999"],
                                   cwd=self.path, stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 2 * OPTIONS.seconds
        while len(children := children_of(process.pid)) < 3:
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)
        process.send_signal(signal.SIGTERM)
        self.assertIn("ended by a signal", process.communicate(timeout=2 * OPTIONS.seconds)[1])
        self.assertEqual(process.returncode, 2)
        self.assertEqual([c for c in children if pathlib.Path("/proc", c).exists()], [])
        self.assertEqual(self.journal(), [])

    def test_only_what_has_changed_runs_again(self):
        self.write("a.nc", GOOD)
        self.write("b.nc", GOOD.replace("M30", "M98 P7000\nM30"))
        self.write("O7000", "O7000\nG0 X30.\nM99\n")
        self.batch()
        self.assertEqual(len(self.journal()), 3)
        self.batch()
        self.assertEqual(len(self.journal()), 3)
        self.write("O7000", "O7000\nG0 X31.\nM99\n")  # b calls it
        self.batch()
        self.assertEqual(sorted(self.journal()[3:]), ["archive/O7000", "archive/b.nc"])  # in the order in which they ended
        self.batch("--set", "IsoCoordinateTable.G54.Z=-120")
        self.assertEqual(len(self.journal()), 8)
        self.write("a.nc", GOOD.replace("X20.", "X21."))
        self.batch("--set", "IsoCoordinateTable.G54.Z=-120", "--changed-since", "out", out="later")
        self.assertEqual(sorted(self.journal("later")), ["archive/O7000", "archive/a.nc", "archive/b.nc"])
        self.assertEqual(len(self.journal()), 8)

    def test_a_program_that_was_missing_is_found_the_next_time(self):
        self.write("main.nc", GOOD.replace("M30", "M98 P7000\nM30"))
        self.batch(status=1)
        self.write("O7000", "O7000\nG0 X30.\nM99\n")
        self.batch()
        self.assertEqual(self.results()["main.nc"]["Status"], "ok")

    def test_a_program_that_was_missing_is_found_in_a_file_that_was_there(self):
        """Files of other names are searched by their contents."""
        self.write("main.nc", GOOD.replace("M30", "M98 P7000\nM30"))
        self.write("library.nc", "O6000\nM99\n")
        places = self.path / "places.nc"
        places.write_text("O5000\nM99\n")
        self.batch("--subprograms", places, status=1)
        self.write("library.nc", "O6000\nM99\nO7000\nG0 X30.\nM99\n")
        self.batch("--subprograms", places)
        self.assertEqual(self.results()["main.nc"]["Status"], "ok")
        self.write("library.nc", "O6000\nM99\n")
        self.batch("--subprograms", places, status=1)
        places.write_text("O5000\nM99\nO7000\nG0 X40.\nM99\n")
        self.batch("--subprograms", places)
        self.assertEqual(self.results()["main.nc"]["Status"], "ok")

    def test_only_a_program_that_looked_for_others_depends_on_its_folder(self):
        self.write("a.nc", BAD)
        self.write("b.nc", GOOD.replace("M30", "M98 P7000\nM30"))
        self.write("notes.txt", "one")
        os.mkfifo(self.archive / "pipe.nc")  # nobody writes into it
        self.batch("--include", "a.nc", "--include", "b.nc", status=1)
        self.assertEqual(sorted(self.journal()), ["archive/a.nc", "archive/b.nc"])
        self.write("notes.txt", "two")
        self.write("c.txt", "")
        self.batch("--include", "a.nc", "--include", "b.nc", status=1)
        self.assertEqual(self.journal()[2:], ["archive/b.nc"])

    def test_folders_of_a_machine_are_places_too(self):
        self.write("a.nc", GOOD.replace("M30", "M98 P7000\nM30"))
        programs = self.path / "shop" / "programs"
        programs.mkdir(parents=True)
        (self.path / "shop" / "machine.xml").write_text(
            '<Machine xmlns="urn:isogloss:dialect:1" name="shop" title="Shop" dialect="fanuc"><Programs src="programs"/></Machine>')
        named = ("--machines", ".", "-m", "shop")
        self.batch(*named, dialect=(), status=1)
        (programs / "O7000").write_text("O7000\nG0 X30.\nM99\n")
        self.batch(*named, dialect=())
        self.assertEqual(self.results()["a.nc"]["Status"], "ok")
        self.assertEqual(len(self.journal()), 2)
        (programs / "O7000").write_text("O7000\nG0 X31.\nM99\n")
        self.batch(*named, dialect=())
        self.assertEqual(len(self.journal()), 3)
        (programs / "O7000").unlink()
        self.batch(*named, dialect=(), status=1)
        self.batch("--changed-since", "out", *named, out="later", dialect=(), status=1)
        (programs / "O7000").write_text("O7000\nG0 X30.\nM99\n")
        self.batch("--changed-since", "out", *named, out="later", dialect=())
        self.assertEqual(self.results("later")["a.nc"]["Status"], "ok")

    def test_folders_below_those_of_a_machine_are_places_too(self):
        """Siemens searches CUS.DIR before CMA.DIR, below the folders of the machine."""
        self.write("a.mpf", "G71 G90\nG0 X1\nL7000\nM30\n")
        programs = self.path / "shop" / "programs"
        (programs / "CMA.DIR").mkdir(parents=True)
        (programs / "CMA.DIR" / "OTHER.SPF").write_text("M17\n")
        (self.path / "shop" / "machine.xml").write_text(
            '<Machine xmlns="urn:isogloss:dialect:1" name="shop" title="Shop" dialect="siemens"><Programs src="programs"/></Machine>')
        named = ("--machines", ".", "-m", "shop")
        self.batch(*named, dialect=(), status=1)
        (programs / "CMA.DIR" / "L7000.SPF").write_text("G0 X30\nM17\n")
        self.batch(*named, dialect=())
        self.assertEqual(self.results()["a.mpf"]["RapidLength_mm"], 30)
        (programs / "CUS.DIR").mkdir()
        (programs / "CUS.DIR" / "L7000.SPF").write_text("G0 X50\nM17\n")
        self.batch(*named, dialect=())
        self.assertEqual(self.results()["a.mpf"]["RapidLength_mm"], 50)
        (programs / "CUS.DIR" / "L7000.SPF").unlink()
        self.batch(*named, dialect=())
        self.assertEqual(self.results()["a.mpf"]["RapidLength_mm"], 30)
        self.batch(*named, dialect=())
        self.assertEqual(len(self.journal()), 4)

    def test_tables_of_a_machine_and_what_they_include_count(self):
        self.write("a.nc", GOOD)
        (self.path / "machines").mkdir()
        tables = self.path / "machines" / "shop.xml"
        offset = '<Dependencies><IsoCoordinateTable><Offset id="G54" Z="{}"/></IsoCoordinateTable></Dependencies>'
        tables.write_text(offset.format(-100))
        named = ("--machines", "machines", "-m", "shop")
        self.batch(*named, dialect=())
        (self.path / "tools.xml").write_text('<Dependencies><IsoCoordinateTable src="more.xml"/></Dependencies>')
        (self.path / "more.xml").write_text(offset.format(-1).replace("<Dependencies>", "").replace("</Dependencies>", ""))
        self.batch("--offsets", "tools.xml", out="included")
        tables.write_text(offset.format(-200))
        self.batch(*named, dialect=())
        self.assertEqual(len(self.journal()), 2)
        (self.path / "more.xml").write_text(offset.format(-2).replace("<Dependencies>", "").replace("</Dependencies>", ""))
        self.batch("--offsets", "tools.xml", out="included")
        self.assertEqual(len(self.journal("included")), 2)

    def test_limits_and_crashes_are_results(self):
        dialect = self.path / "bad.xml"
        dialect.write_text('<Dialect xmlns="urn:isogloss:dialect:1" name="bad" extends="fanuc">'
                           '<Plugins><Plugin name="cli_bad_plugin"/></Plugins><Chain>'
                           '<InsertBefore syntax="WordSyntax"><MisbehaveSyntax/></InsertBefore></Chain></Dialect>')
        self.write("crash.nc", "G0 X1.\nM901\nM30\n")
        self.write("good.nc", GOOD)
        self.write("loop.nc", "N1 G1 X1. F100.\nX0\nGOTO 1\nM30\n")
        self.write("noise.nc", "M906\nM30\n")
        self.write("printing.nc", GOOD.replace("M30", "M905\nM30"))
        bad = ("--plugins", OPTIONS.bad_plugins, "--max-time", 2 * (OPTIONS.seconds // 5 + 1), "--max-jumps", 999999999, "--max-loop-blocks",
               99999999999)
        self.batch(*bad, dialect=("-d", "bad.xml"), status=3)
        results = self.results()
        self.assertEqual({name: r["Status"] for name, r in results.items()},
                         {"crash.nc": "fault", "good.nc": "ok", "loop.nc": "out of time", "noise.nc": "out of time",
                          "printing.nc": "ok"})
        self.assertEqual(results["printing.nc"]["Feeds"], 2)
        self.assertIn("MisbehaveSyntax", results["crash.nc"]["First"]["Message"])
        self.assertIn("it was not done after", results["loop.nc"]["First"]["Message"])
        self.write("loop.nc", GOOD)
        self.write("noise.nc", GOOD)
        self.batch(*bad, dialect=("-d", "bad.xml"), status=3)
        self.assertEqual(len(self.journal()), 7)
        self.batch(*bad, "--retry", dialect=("-d", "bad.xml"), status=3)
        self.assertEqual(self.journal()[7:], ["archive/crash.nc"])

    def test_what_a_plugin_does_to_its_process_stops_no_batch(self):
        """A program that closes its outputs and loops, and one that leaves a process behind which holds them."""
        dialect = self.path / "bad.xml"
        dialect.write_text('<Dialect xmlns="urn:isogloss:dialect:1" name="bad" extends="fanuc">'
                           '<Plugins><Plugin name="cli_bad_plugin"/></Plugins><Chain>'
                           '<InsertBefore syntax="WordSyntax"><MisbehaveSyntax/></InsertBefore></Chain></Dialect>')
        self.write("behind.nc", GOOD.replace("M30", "M908\nM30"))
        self.write("closed.nc", "M907\nN1 G1 X1. F100.\nX0\nGOTO 1\nM30\n")
        self.write("held.nc", "M908\nN1 G1 X1. F100.\nX0\nGOTO 1\nM30\n")
        self.batch("--plugins", OPTIONS.bad_plugins, "--max-time", 2 * (OPTIONS.seconds // 5 + 1), "--max-jumps", 999999999,
                   "--max-loop-blocks", 99999999999, dialect=("-d", "bad.xml"), status=1)
        self.assertEqual({name: r["Status"] for name, r in self.results().items()},
                         {"behind.nc": "ok", "closed.nc": "out of time", "held.nc": "out of time"})
        self.assertEqual(self.results()["behind.nc"]["Feeds"], 2)

    def test_processes_that_have_left_the_group_of_their_program_end(self):
        """With their program, with its limit, and with a batch that a signal ends."""
        (self.path / "bad.xml").write_text(
            '<Dialect xmlns="urn:isogloss:dialect:1" name="bad" extends="fanuc">'
            '<Plugins><Plugin name="cli_bad_plugin"/></Plugins><Chain>'
            '<InsertBefore syntax="WordSyntax"><MisbehaveSyntax/></InsertBefore></Chain></Dialect>')
        environment = {**os.environ, "MARK_OF_TEST": str(self.path)}
        mark = f"MARK_OF_TEST={self.path}".encode()

        def marked():
            out = []
            for file in pathlib.Path("/proc").glob("[0-9]*/environ"):
                try:
                    out += [int(file.parent.name)] if mark in file.read_bytes().split(b"\0") else []
                except OSError:  # it is gone, or another user's
                    pass
            return out

        def begin(program, seconds):
            self.write("a.nc", program)
            return subprocess.Popen([OPTIONS.isogloss, "batch", "archive", "-d", "bad.xml", "-o", "out", "--plugins",
                                     OPTIONS.bad_plugins, "--max-jumps", "999999999", "--max-loop-blocks", "99999999999",
                                     "--max-time", str(seconds)], cwd=self.path, stderr=subprocess.DEVNULL, env=environment)
        loop = "M909\nN1 G1 X1. F100.\nX0\nGOTO 1\nM30\n"
        self.assertEqual(begin(GOOD.replace("M30", "M909\nM30"), 600).wait(10 * OPTIONS.seconds), 0)
        self.assertEqual(marked(), [])
        self.assertEqual(begin(loop, OPTIONS.seconds // 8 + 1).wait(10 * OPTIONS.seconds), 1)
        self.assertEqual(self.results()["a.nc"]["Status"], "out of time")
        self.assertEqual(marked(), [])
        process = begin(loop.replace("X1.", "X2."), 600)
        deadline = time.monotonic() + 2 * OPTIONS.seconds
        while len(marked()) < 4:  # the batch, the program, and two more
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)
        process.terminate()
        self.assertEqual(process.wait(10 * OPTIONS.seconds), 2)
        self.assertEqual(marked(), [])

    def test_a_batch_that_was_stopped_takes_no_program_for_late(self):
        self.write("a.nc", LONG.replace("600000", "150000") + GOOD)  # it is seen at work, and ends soon
        most = max(OPTIONS.seconds // 4, 2)
        process = self.begun("--max-time", str(most))
        process.send_signal(signal.SIGSTOP)
        time.sleep(most + 0.2)
        process.send_signal(signal.SIGCONT)
        process.communicate(timeout=20 * OPTIONS.seconds)
        self.assertEqual(self.results()["a.nc"]["Status"], "ok")

    def test_a_batch_that_was_stopped_while_it_kept_a_result_takes_no_program_for_late(self):
        """The first program looks for another one among files that take a while to be hashed."""
        self.write("a.nc", GOOD.replace("M30", "M98 P7000\nM30"))
        self.write("b.nc", GOOD.replace("M30", LONG + "M30"))
        library = self.path / "library"
        library.mkdir()
        for number in range(12):
            with (library / f"{number}.dat").open("wb") as file:
                file.truncate(1 << 26)
        most = OPTIONS.seconds * 3 // 2
        process = self.begun("-j2", "--max-time", str(most), "--subprograms", "library")
        deadline = time.monotonic() + 2 * OPTIONS.seconds
        while len(left := children_of(process.pid)) != 1 or not self.is_at_work(left[0], "b.nc"):
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.002)
        for number, seconds in ((signal.SIGSTOP, most), (signal.SIGCONT, 0)):
            for pid in (process.pid, int(left[0])):
                os.kill(pid, number)
            time.sleep(seconds)
        process.communicate(timeout=20 * OPTIONS.seconds)
        self.assertEqual(self.results()["b.nc"]["Status"], "ok")

    @staticmethod
    def is_at_work(process, program):
        return program.encode() in pathlib.Path("/proc", process, "cmdline").read_bytes()

    def test_results_are_those_of_one_batch_or_of_none(self):
        """The page of results is larger than the file system takes."""
        self.write("a.nc", GOOD)
        self.assertIn("1 program: 1 ok", self.batch().stderr)
        before = [(self.path / "out" / name).read_bytes() for name in RESULTS]
        self.write("a.nc", BAD)
        done = subprocess.run([OPTIONS.isogloss, "batch", "archive", "-d", "fanuc", "-o", "out"], cwd=self.path,
                              capture_output=True, text=True, check=False,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096)))
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("overview.html: error", done.stderr)
        self.assertEqual([(self.path / "out" / name).read_bytes() for name in RESULTS], before)
        self.assertEqual(len(list((self.path / "out").iterdir())), len(RESULTS) + 1)
        self.batch(status=1)
        self.assertEqual(len(self.journal()), 2)

    def test_a_journal_on_a_full_disc_keeps_whole_lines(self):
        self.archive_of(9)
        done = subprocess.run([OPTIONS.isogloss, "batch", "archive", "-d", "fanuc", "-o", "out", "-j1"], cwd=self.path,
                              capture_output=True, text=True, check=False,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096)))
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("[IG-0675]", done.stderr)
        kept = len(self.journal())
        self.assertIn(kept, range(1, 9))
        said = self.batch().stderr
        self.assertIn(f"{kept} of 9 programs were finished before", said)
        self.assertNotIn("[IG-0672]", said)

    def test_a_part_whose_journal_is_removed_has_not_finished(self):
        self.write("a.nc", GOOD)
        self.write("b.nc", f"G21 G90\nG0 X1.\n{LONG}M30\n")
        process = self.begun("-j1", "--shard", "1/1")
        deadline = time.monotonic() + 2 * OPTIONS.seconds
        while not list(self.path.glob("out/journal/*.jsonl")):
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.002)
        shutil.rmtree(self.path / "out")
        said = process.communicate(timeout=20 * OPTIONS.seconds)[1]
        self.assertEqual(process.returncode, 2, said)
        self.assertIn("[IG-0675]", said)

    def test_batches_write_results_into_one_folder_one_after_the_other(self):
        self.write("a.nc", GOOD)
        self.batch()
        (self.path / "out/results.csv").unlink()
        (self.path / "out/results.jsonl.isogloss-Ab3dEf").write_text("left by a kill")
        (self.path / "out/results.csv.backup").write_text("mine")
        folder = os.open(self.path / "out", os.O_RDONLY)
        self.addCleanup(os.close, folder)
        fcntl.flock(folder, fcntl.LOCK_EX)
        process = subprocess.Popen([OPTIONS.isogloss, "batch", "archive", "-d", "fanuc", "-o", "out"], cwd=self.path,
                                   stderr=subprocess.DEVNULL)
        time.sleep(0.3)
        self.assertIsNone(process.poll())
        self.assertFalse((self.path / "out/results.csv").exists())
        fcntl.flock(folder, fcntl.LOCK_UN)
        self.assertEqual(process.wait(10 * OPTIONS.seconds), 0)
        self.assertEqual({file.name for file in (self.path / "out").iterdir()},
                         {*RESULTS, "journal", "results.csv.backup"})

    def begun(self, *more, out="out", programs=1):
        """A batch that is at work on so many programs."""
        process = subprocess.Popen([OPTIONS.isogloss, "batch", "archive", "-d", "fanuc", "-o", out, *more], cwd=self.path,
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.stderr.close)
        deadline = time.monotonic() + 2 * OPTIONS.seconds
        while len(children_of(process.pid)) < programs:
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.002)
        return process

    def test_a_table_that_changes_meanwhile_lets_all_begin_anew(self):
        offset = '<Dependencies><IsoCoordinateTable><Offset id="G54" X="{}"/></IsoCoordinateTable></Dependencies>'
        table = self.path / "offsets.xml"
        for number in range(2):
            self.write(f"{number}.nc", f"G21 G90 G54\nG0 X0\n{LONG}G0 X1.\nM30\n")
        table.write_text(offset.format(-100))
        self.batch("--offsets", "offsets.xml", out="first")
        table.write_text(offset.format(-200))
        self.batch("--offsets", "offsets.xml", out="second")
        table.write_text(offset.format(-100))
        process = self.begun("--offsets", "offsets.xml", "-j1")
        time.sleep(0.1)
        table.write_text(offset.format(-200))
        said = process.communicate(timeout=20 * OPTIONS.seconds)[1]
        self.assertEqual(process.returncode, 0, said)
        self.assertIn("offsets.xml has changed since the batch began: it begins anew", said)
        for name in RESULTS:
            self.assertEqual((self.path / "out" / name).read_bytes(), (self.path / "second" / name).read_bytes(), name)
        table.write_text(offset.format(-100))  # no result of the other table counts as one of this
        self.batch("--offsets", "offsets.xml")
        for name in RESULTS:
            self.assertEqual((self.path / "out" / name).read_bytes(), (self.path / "first" / name).read_bytes(), name)

    def test_a_program_that_changes_while_it_runs_runs_again(self):
        for changed in ("main.nc", "O7000"):
            with self.subTest(changed):
                self.write("O7000", "O7000\nG0 X30.\nM99\n")
                main = f"G21 G90\nG0 X1.\nM98 P7000\n{LONG}M30\n"
                self.write("main.nc", main)
                process = self.begun("--include", "main.nc", out=changed)
                time.sleep(0.3)
                if changed == "O7000":
                    self.write("O7000", "O7000\nG0 X70.\nM99\n")
                else:
                    self.write("main.nc", main.replace("M98 P7000", "G0 X70."))
                said = process.communicate(timeout=20 * OPTIONS.seconds)[1]
                self.assertEqual(process.returncode, 0, said)
                self.assertEqual(self.results(changed)["main.nc"]["RapidLength_mm"], 70)
                self.batch("--include", "main.nc", out=changed)
                self.assertEqual(len(self.journal(changed)), 1)

    def test_results_in_the_folder_of_the_machine_change_no_machine(self):
        self.write("a.nc", GOOD)
        (self.path / "shop").mkdir()
        (self.path / "shop" / "machine.xml").write_text(
            '<Machine xmlns="urn:isogloss:dialect:1" name="shop" title="Shop" dialect="fanuc"/>')
        for _ in range(3):
            self.batch("--machines", ".", "-m", "shop", dialect=(), out="shop/results")
        self.assertEqual(len(self.journal("shop/results")), 1)

    def test_a_folder_of_the_search_order_that_comes_later_counts(self):
        """Folders such as CUS.DIR are searched one folder further down, too."""
        self.write("a.mpf", "G71 G90\nG0 X1\nL7000\nM30\n")
        card = self.path / "card" / "MILL"
        card.mkdir(parents=True)
        (card / "notes.txt").write_text("no program")
        named = ("--subprograms", "card")
        self.batch(*named, dialect=("-d", "siemens"), status=1)
        self.batch(*named, dialect=("-d", "siemens"), status=1)
        self.assertEqual(len(self.journal()), 1)
        (card / "CUS.DIR").mkdir()
        (card / "CUS.DIR" / "L7000.SPF").write_text("G0 X30\nM17\n")
        self.batch(*named, dialect=("-d", "siemens"))
        self.assertEqual(self.results()["a.mpf"]["RapidLength_mm"], 30)

    def test_a_folder_that_changes_meanwhile_counts_as_each_program_saw_it(self):
        """O7000 goes between the first program and the last one, and comes back."""
        call = GOOD.replace("M30", "M98 P7000\nM30")
        self.write("a.nc", call.replace("M98", "M98 P8000\nM98"))  # which looks inside the files as well, as c.nc does
        self.write("b.nc", GOOD.replace("M30", LONG + "M30"))
        self.write("c.nc", call)
        library = self.path / "library"
        library.mkdir()
        called = library / "O7000.nc"
        called.write_text("O7000\nG0 X30.\nM99\n")
        process = subprocess.Popen([OPTIONS.isogloss, "batch", "archive", "-d", "fanuc", "-o", "out", "-j1", "--subprograms",
                                    "library"], cwd=self.path, stderr=subprocess.PIPE)
        deadline = time.monotonic() + 2 * OPTIONS.seconds
        while self.journal() != ["archive/a.nc"]:
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)
        called.rename(self.path / "away.nc")
        said = process.communicate(timeout=20 * OPTIONS.seconds)[1]
        self.assertEqual([self.results()[name]["Status"] for name in ("b.nc", "c.nc")], ["ok", "errors"], said)
        (self.path / "away.nc").rename(called)
        self.batch("--subprograms", "library", status=1)
        self.assertEqual(self.results()["c.nc"]["Status"], "ok")

    def test_a_file_that_was_read_for_a_program_counts_as_each_program_saw_it(self):
        """Its folder stays as it is: O7000 goes from a file of another name, and comes back."""
        without, with_it = "O6000\nM99\n", "O6000\nM99\nO7000\nG0 X30.\nM99\n"
        call = GOOD.replace("M30", "M98 P7000\nM30")
        self.write("a.nc", call)
        self.write("b.nc", GOOD.replace("M30", LONG + "M30"))
        self.write("c.nc", call)
        library = self.path / "library" / "o6000.nc"
        library.parent.mkdir()
        library.write_text(with_it)
        process = self.begun("-j1", "--subprograms", "library")
        deadline = time.monotonic() + 2 * OPTIONS.seconds
        while self.journal() != ["archive/a.nc"]:
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)
        library.write_text(without)
        said = process.communicate(timeout=20 * OPTIONS.seconds)[1]
        self.assertEqual([self.results()[name]["Status"] for name in ("a.nc", "c.nc")], ["ok", "errors"], said)
        library.write_text(with_it)
        self.batch("--subprograms", "library")
        self.assertEqual([self.results()[name]["Status"] for name in ("a.nc", "c.nc")], ["ok", "ok"])

    def test_a_program_runs_again_when_a_file_that_was_read_for_it_changes_meanwhile(self):
        self.write("a.nc", GOOD.replace("M30", "M98 P7000\n" + 3 * LONG + "M30"))
        library = self.path / "library" / "o6000.nc"
        library.parent.mkdir()
        library.write_text("O6000\nM99\n")
        process = self.begun("--subprograms", "library", "--max-jumps", "99999999")
        [child] = children_of(process.pid)
        deadline = time.monotonic() + 2 * OPTIONS.seconds
        while self.seconds_of_processor(child) < 0.3:  # it is far behind the call
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)
        library.write_text("O6000\nM99\nO7000\nG0 X30.\nM99\n")
        said = process.communicate(timeout=20 * OPTIONS.seconds)[1]
        self.assertEqual(self.results()["a.nc"]["Status"], "ok", said)

    @staticmethod
    def seconds_of_processor(process):
        fields = pathlib.Path("/proc", process, "stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def test_the_order_of_the_dialect_folders_counts(self):
        self.write("a.nc", GOOD + "G999\n")
        for name in ("one", "two"):
            (self.path / name).mkdir()
            base = "fanuc" if name == "one" else "heidenhain"
            (self.path / name / "mine.xml").write_text(
                f'<Dialect xmlns="urn:isogloss:dialect:1" name="mine" extends="{base}"/>')
        for more in ((), ("--untrusted",)):
            for number, order in enumerate((("one", "two"), ("two", "one"), ("one", "two"))):
                with self.subTest(more, order=order):
                    named = (f"--dialects={folder}" for folder in order)
                    command("batch", "archive", "-d", "mine", *named, "-o", f"out{len(more)}", *more, cwd=self.path)
                    self.assertEqual(len(self.journal(f"out{len(more)}")), min(number, 1) + 1)

    def test_a_called_program_without_the_start_that_is_asked_for_counts(self):
        self.write("main.nc", GOOD.replace("M30", "M98 P7000 Q10\nM30"))
        self.write("O7000", "O7000\nG0 X30.\nM99\n")
        named = ("--include", "main.nc")
        self.batch(*named, status=1)
        self.write("O7000", "O7000\nN10 G0 X30.\nM99\n")
        self.batch(*named)

    def test_a_journal_that_cannot_be_read_is_told(self):
        self.write("a.nc", GOOD)
        self.batch()
        [file] = (self.path / "out/journal").iterdir()
        file.unlink()
        file.symlink_to("nowhere")
        self.assertIn("[IG-0672]", self.batch().stderr)

    def test_what_was_run_again_replaces_a_failure(self):
        self.write("a.nc", GOOD)
        self.batch()
        [file] = (self.path / "out/journal").iterdir()
        file.write_text(file.read_text().replace('"Status":"ok"', '"Status":"crashed"'))
        self.batch(status=3)
        self.batch("--retry")
        self.assertEqual(self.results()["a.nc"]["Status"], "ok")
        self.batch("--merge")

    def test_a_process_that_others_kill_is_started_once_more(self):
        self.write("a.nc", "N1 G1 X1. F100.\nX0\nGOTO 1\nM30\n")
        process = subprocess.Popen([OPTIONS.isogloss, "batch", "archive", "-d", "fanuc", "-o", "out", "--max-jumps", "3000000"],
                                   cwd=self.path, stderr=subprocess.DEVNULL)
        deadline = time.monotonic() + 2 * OPTIONS.seconds
        while not (children := children_of(process.pid)):
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.001)
        os.kill(int(children[0]), signal.SIGKILL)
        self.assertEqual(process.wait(10 * OPTIONS.seconds), 1)
        self.assertEqual(self.results()["a.nc"]["Status"], "errors")  # its jumps have a limit
        self.assertEqual(len(self.journal()), 1)

    def test_names_of_any_bytes_are_found_again(self):
        for name in (b"M\xdcLLER.nc", "M\u00dcLLER.nc".encode(), b"100%25.nc", b"line\nbreak.nc"):
            (pathlib.Path(os.fsdecode(os.fsencode(self.archive) + b"/" + name))).write_text(GOOD)
        for _ in range(2):
            self.batch()
            self.assertEqual(len(self.journal()), 4)
        self.batch("--merge")
        self.assertIn("archive/M\ufffdLLER.nc", (self.path / "out/results.csv").read_text())

    def test_names_that_look_like_options_formulas_or_no_text(self):
        names = ["--help", "-x.nc", "=1+1.nc", "@SUM(A1).nc", "+1.nc", "\t=1.nc", "]]>&.nc", "\ufffe.nc", "\uffff.nc"]
        for name in names:
            self.write(name, GOOD)
        done = subprocess.run([OPTIONS.isogloss, "batch", "-d", "fanuc", "-o", "../out", "--", *names], cwd=self.archive,
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        done = subprocess.run([OPTIONS.isogloss, "batch", ".", "-d", "fanuc", "-o", "../below"], cwd=self.archive,
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        for out in ("out", "below"):
            with (self.path / out / "results.csv").open(newline="", encoding="utf-8") as table:
                rows = list(csv.DictReader(table))
            self.assertEqual(sorted(row["Program"].removeprefix("./") for row in rows), sorted(names))
            self.assertEqual([row["Program"] for row in rows if row["Program"][0] in "=+-@\t"], [])
            suite = xml.etree.ElementTree.parse(self.path / out / "results.xml").getroot()[0]
            self.assertEqual(len(suite), len(names))

    def test_a_message_that_looks_like_a_formula_is_text(self):
        self.write("a.nc", GOOD)
        self.batch()
        [file] = (self.path / "out/journal").iterdir()
        result = json.loads(file.read_text())
        result["Result"]["First"] = {"Severity": "warning", "Message": "=1+1"}
        file.write_text(json.dumps(result) + "\n")
        self.batch()
        with (self.path / "out/results.csv").open(newline="") as table:
            self.assertEqual(next(csv.DictReader(table))["First"], "'=1+1")

    def test_few_file_descriptors_mean_few_processes(self):
        self.archive_of(6)
        for most, status in ((12, 0), (5, 2)):
            done = subprocess.run([OPTIONS.isogloss, "batch", "archive", "-d", "fanuc", "-o", f"out{most}", "-j", "20"],
                                  cwd=self.path, capture_output=True, text=True, check=False, timeout=20 * OPTIONS.seconds,
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (most, most)))
            self.assertEqual(done.returncode, status, done.stderr)
        self.assertIn("[IG-0675]", done.stderr)

    def test_what_is_no_program_is_left_out(self):
        self.write("part.nc", GOOD)
        self.write("offsets.xml", "<x/>")
        self.write("drawing.dxf", b"AC10\0\0")
        self.write(".git/O1", GOOD)
        self.assertIn("[IG-0671]", self.batch(out="archive/out").stderr)
        self.assertEqual(list(self.results("archive/out")), ["part.nc"])
        self.batch(out="archive/out")  # its own results are no programs
        self.assertEqual(list(self.results("archive/out")), ["part.nc"])
        self.batch(out="archive/next")  # nor are those of another batch
        self.assertEqual(list(self.results("archive/next")), ["part.nc"])
        for file in (self.archive / "out/journal").iterdir():  # as a kill may leave it
            file.write_text("")
        self.batch(out="archive/next")
        self.assertEqual(list(self.results("archive/next")), ["part.nc"])
        self.assertIn("[IG-0670]", self.batch("--include", "*.mpf", out="other", status=2).stderr)
        self.write("sub/x.mpf", GOOD)
        self.batch("--include", "*.mpf", "--include", "p*", "--exclude", "sub/*", out="other")
        self.assertEqual(list(self.results("other")), ["part.nc"])

    def test_a_program_is_a_file_that_its_path_leads_to(self):
        """Behind a link, .. leads elsewhere than the text of the path; a program that is named twice runs once."""
        self.write("other/sub/x.nc", BAD)
        self.write("other/a.nc", GOOD)
        self.write("a.nc", BAD)
        (self.archive / "link").symlink_to("other/sub")
        self.batch(places=("archive/link/../a.nc",))
        self.batch(places=("archive/a.nc", "archive/other/../a.nc", self.archive / "a.nc"), out="twice", status=1)
        self.assertEqual(len((self.path / "twice/results.jsonl").read_text().splitlines()), 1)
        os.mkfifo(self.archive / "pipe.nc")
        (self.archive / "loop.nc").symlink_to("loop.nc")
        for name in ("pipe.nc", "loop.nc"):
            self.assertIn("[IG-0510]", self.batch(places=(self.archive / name,), out="none", status=2).stderr)
        (self.path / "list.txt").write_text("archive/a.nc\narchive/pipe.nc\n")
        self.assertIn("[IG-0510]", self.batch("--list", "list.txt", places=(), out="none", status=2).stderr)

    def test_a_list_names_programs(self):
        self.write("a.nc", GOOD)
        self.write("b.nc", GOOD)
        list_file = self.path / "list.txt"
        list_file.write_text("\ufeffarchive/b.nc\r\n\narchive/b.nc\n", encoding="utf-8")
        self.batch("--list", "list.txt", places=())
        self.assertEqual(list(self.results()), ["b.nc"])
        list_file.write_text("archive/b.nc\narchive/none.nc\n")
        self.assertIn("list.txt:2:1: error", self.batch("--list", "list.txt", places=(), out="other", status=2).stderr)
        done = command("batch", "--list", "-", "-d", "fanuc", "-o", "piped", cwd=self.path, given="archive/a.nc\n")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(list(self.results("piped")), ["a.nc"])

    def test_a_path_that_no_system_takes_is_told(self):
        self.write("a.nc", GOOD)
        (self.path / "list.txt").write_text("archive/a.nc\n" + "x" * 5000 + "\n")
        self.assertIn("list.txt:2:1: error", self.batch("--list", "list.txt", places=(), status=2).stderr)

    def test_a_folder_that_is_not_there_is_told_once(self):
        self.write("a.nc", GOOD)
        self.write("b.nc", GOOD)
        self.assertEqual(self.batch("--plugins", "misspelt").stderr.count("[IG-0612]"), 1)
        self.assertEqual([r["Diagnostics"] for r in self.results().values()], [[], []])

    def test_an_earlier_batch_that_is_not_there_is_told(self):
        self.write("a.nc", GOOD)
        self.assertIn("[IG-0677]", self.batch("--changed-since", "misspelt").stderr)
        self.assertNotIn("[IG-0677]", self.batch("--changed-since", "out", out="next").stderr)

    def test_a_batch_in_a_folder_that_is_gone_is_told(self):
        gone = self.path / "gone"
        program = self.write("a.nc", GOOD)
        text = 'mkdir "$1" && cd "$1" && rmdir "$1" && exec "$2" batch "$3" -d fanuc -o "$4" --slurm 2 --no-submit'
        for out in ("out", self.path / "out"):
            done = subprocess.run(["sh", "-c", text, "sh", gone, OPTIONS.isogloss, program, out], capture_output=True,
                                  text=True, check=False)
            self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
            self.assertIn("[IG-0513]", done.stderr)

    def test_a_file_of_paths_is_a_list(self):
        self.write("a.nc", GOOD)
        self.write("sub/b.nc", GOOD)
        list_file = self.path / "list.txt"
        list_file.write_text("\r\narchive/sub\r\narchive/a.nc\n")
        self.assertRegex(self.batch(places=["list.txt"]).stderr, r"list.txt:1:1: note: .*\[IG-0676\]")
        self.assertEqual(list(self.results()), ["a.nc", "sub/b.nc"])
        list_file.write_text("archive/a.nc\narchive/none.nc\n")
        self.assertIn("list.txt:2:1: error", self.batch(places=["list.txt"], out="missing", status=2).stderr)
        # The first line of a program may be the name of a file, and of the program's own.
        (self.path / "O0001").write_text("O0001\n" + GOOD)
        (self.path / "O0002").write_text("O0001\n" + GOOD)
        (self.path / "skipped.nc").write_text("/\n" + GOOD)
        done = self.batch(places=["O0001", "O0002", "skipped.nc"], out="programs")
        self.assertNotIn("[IG-0676]", done.stderr)
        self.assertEqual(len((self.path / "programs" / "results.jsonl").read_text().splitlines()), 3)

    def test_scripts_for_slurm_run_the_parts_and_merge_them(self):
        self.archive_of(9)
        self.batch(out="whole")
        self.assertIn("sbatch", self.batch("--slurm", "2", "--no-submit", "--slurm-options", "--partition=it's").stderr)
        self.assertIn("#SBATCH --partition=it's\n", (self.path / "out/slurm/parts.sh").read_text())
        own = ("--retry", "-j1", "--changed-since", "whole")  # of the parts; the job that merges runs nothing
        self.batch("--slurm", "2", "--no-submit", *own, out="other")
        for word in ("--retry", "-j1", "--changed-since", "whole"):
            self.assertIn(f"'{word}'", (self.path / "other/slurm/parts.sh").read_text())
            self.assertNotIn(f"'{word}'", (self.path / "other/slurm/merge.sh").read_text())
        for name in ("--slurm", "-jx.nc"):  # behind -- they are programs
            self.write(name, GOOD)
        for script in ("parts", "merge"):
            subprocess.run([OPTIONS.isogloss, "batch", "-d", "fanuc", "-o", "../named", "--slurm", "1", "--no-submit", "--",
                            "--slurm", "-jx.nc"], cwd=self.archive, capture_output=True, check=True)
            subprocess.run(["sh", self.path / f"named/slurm/{script}.sh"], check=True, capture_output=True,
                           env={**os.environ, "SLURM_ARRAY_TASK_ID": "1"})
        self.assertEqual(len((self.path / "named/results.jsonl").read_text().splitlines()), 2)
        for name in ("--slurm", "-jx.nc"):
            (self.archive / name).unlink()
        # In place of the real sbatch: it runs all parts at once and refuses nothing.
        tool = self.path / "bin/sbatch"
        tool.parent.mkdir()
        tool.write_text('''#!/bin/sh
for script; do :; done
case $script in
  *parts.sh) echo "sbatch: warning: no account" >&2; for part in 1 2 3; do SLURM_ARRAY_TASK_ID=$part sh "$script" 2>>parts.log; done; echo "7;cluster" ;;
  *) test "$2" = --dependency=afterany:7 && sh "$script" 2>merge.log && echo 8 ;;
esac
''')
        tool.chmod(0o755)
        environment = {**os.environ, "PATH": f"{tool.parent}:{os.environ['PATH']}"}
        done = subprocess.run([OPTIONS.isogloss, "batch", "archive", "-d", "fanuc", "--slurm=3", "-o", "out"], cwd=self.path,
                              env=environment, capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        self.assertIn("job 7 runs 3 parts, job 8 merges them", done.stderr)
        self.assertEqual(len(self.journal()), 9)
        for name in RESULTS:
            self.assertEqual((self.path / "out" / name).read_bytes(), (self.path / "whole" / name).read_bytes(), name)
        tool.write_text("#!/bin/sh\necho 'sbatch: error: invalid partition' >&2\nexit 1\n")
        done = subprocess.run([OPTIONS.isogloss, "batch", "archive", "-d", "fanuc", "--slurm=3", "-o", "out"], cwd=self.path,
                              env=environment, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("invalid partition", done.stderr)
        self.assertIn("[IG-0674]", done.stderr)

    def test_wrong_use(self):
        self.write("a.nc", GOOD)
        for more, places, code in ((("--shard", "3/2"), ("archive",), "IG-0513"), (("--shard", "x"), ("archive",), "IG-0513"),
                                   (("--shard", "1/2", "--merge"), ("archive",), "IG-0513"), ((), (), "IG-0513"),
                                   (("--slurm", "2", "--merge"), ("archive",), "IG-0513"),
                                   (("--slurm", "2", "--list", "-"), (), "IG-0513"),
                                   ((), ("nowhere",), "IG-0510"), ((), ("archive", "out"), "IG-0510")):
            with self.subTest(more=more):
                self.assertIn(f"[{code}]", self.batch(*more, places=places, status=2).stderr)
        (self.path / "wrong.xml").write_text(
            '<MacroVariables xmlns="urn:isogloss:dialect:1"><Variable name="#500"/></MacroVariables>')
        for named, places, code in ((("-d", "fanuk"), ("archive",), "IG-0101"), (("-d", "fanuc"), ("nowhere",), "IG-0510"),
                                    (("-d", "fanuc", "--tools", "none.xml"), ("archive",), "IG-0102"),
                                    (("-d", "fanuc", "--variables", "wrong.xml"), ("archive",), "IG-0219"),
                                    (("-d", "fanuc", "--set", "Foo.Bar=1"), ("archive",), "IG-0410"),
                                    (("-d", "fanuc", "--set", "MacroVariables.500.Value=x"), ("archive",), "IG-0411")):
            with self.subTest(named, places=places):
                done = self.batch("--slurm", "2", "--no-submit", dialect=named, places=places, status=2)
                self.assertIn(f"[{code}]", done.stderr)
                self.assertFalse((self.path / "out/slurm").exists())
        self.assertIn("no backslash", self.batch("--slurm", "2", "--no-submit", out="a\\b", status=2).stderr)
        self.assertIn("[IG-0513]", self.batch(out="archive", status=2).stderr)
        self.assertIn("[IG-0101]", self.batch(dialect=("-d", "fanuk"), status=2).stderr)
        (self.path / "file").write_text("")
        self.assertIn("[IG-0511]", self.batch(out="file", status=2).stderr)
        self.assertFalse((self.path / "out").exists())

    def test_real_programs_of_all_dialects(self):
        for family in ("fanuc", "siemens", "heidenhain"):
            for program in sorted((PROGRAMS / family).glob("*/*.nc"))[:4]:
                self.write(f"{family}/{program.name}", program.read_bytes())
        done = self.batch(dialect=(), status=1)  # without their tables
        self.assertGreater(len(self.results()), 5, done.stderr)
        for result in self.results().values():
            self.assertIn(result["Status"], ("ok", "errors"), result)
            self.assertTrue(result["Dialect"])


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--bad-plugins", required=True)
    parser.add_argument("--seconds", type=int, default=8, help="within which a short program ends")
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.bad_plugins = str(pathlib.Path(OPTIONS.bad_plugins).resolve())
    OPTIONS.isogloss = str(OPTIONS.isogloss.resolve())
    unittest.main(argv=[sys.argv[0], *rest])
