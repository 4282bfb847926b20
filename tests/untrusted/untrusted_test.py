#!/usr/bin/env python3
"""--untrusted: what hostile plugins and programs try is refused and reported, and sound ones notice nothing.

  untrusted_test.py --isogloss PATH --hostile FOLDER [--seconds N] [--sanitized] [unittest's own options]

Each deed that is harmless is done without --untrusted as well, where it must succeed: otherwise the test would pass
because the plugin cannot do it at all.
"""
import argparse
import ctypes
import fcntl
import json
import os
import pathlib
import pty
import resource
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

HERE = pathlib.Path(__file__).resolve().parent
PROGRAMS = HERE.parent / "programs"
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import FACTOR  # noqa: E402: it lies in another folder

OPTIONS = None
PART = "G90 G54 G21 G17 G94\nG00 X1. Y2. Z3.\nG01 X5. F100.\nM30\n"
DIALECT = ('<Dialect xmlns="urn:isogloss:dialect:1" name="hostile" extends="iso"><Plugins><Plugin name="hostile"/>'
           '</Plugins><Chain><InsertBefore syntax="ProgramXyzSyntax"><BadSyntax/></InsertBefore></Chain></Dialect>')

# The call that is named, and whether the deed succeeds without --untrusted. None: there it would do harm.
REFUSED = {
    "creates": ("openat", True),
    "truncates": ("openat", True),
    "writes_by_old_call": ("creat", True),
    "makes_temporary": ("openat", True),
    "removes": ("unlink", True),
    "renames": ("rename", True),
    "changes_mode": ("chmod", True),
    "makes_link": ("symlink", True),
    "connects": ("socket", True),
    "executes": ("execve", None),
    "starts": ("clone", True),
    "forks": ("clone", True),
    "bombs": ("clone", None),
    "kills_parent": ("kill", None),
    "kills_group": ("kill", None),
    "kills_all": ("kill", None),
    "kills_by_thread": ("tgkill", None),
    "kills_by_descriptor": ("pidfd_open", None),
    "traces_parent": ("ptrace", None),
    "writes_parents_memory": ("process_vm_writev", None),
    "writes_own_memory": ("openat", True),
    "lifts_limits": ("prlimit64", None),
    "outlives_parent": ("prctl", True),
    "sends_to_terminal": ("ioctl", None),
    "unshares": ("unshare", None),
    "mounts": ("mount", None),
    "keeps_in_memory": ("memfd_create", True),
    "shares_memory": ("shmget", None),
    "shares_memory_without_a_file": ("mmap", True),
    "makes_ring": ("io_uring_setup", None),
    "changes_flags_of_output": ("fcntl", True),
}
# These are architecture-independent moments; "destroy" runs when the dialect is let go.
MOMENTS = ("load", "entry", "create", "build")

# What ends the work without a call that is refused.
ENDED = {
    "loops": ("build", ("it was not done after 2 s", "it used more than 2 s of the processor"), 1),
    "loops_without_watch": ("load", ("it was not done after 2 s", "it used more than 2 s of the processor"), 1),
    "sleeps": ("build", ("it was not done after 2 s",), 1),
    "stops_itself": ("build", ("it was not done after 2 s",), 1),
    "closes_output_and_loops": ("load", ("it was not done after 2 s", "it used more than 2 s of the processor"), 1),
    "starts_threads": ("build", ("it began more than 64 threads",), 1),
    "hides_threads": ("build", ("it began more than 64 threads",), 1),
    "prints_without_end": ("build", ("it printed more than 67108864 bytes",), 1),
    "quits": ("load", ("it ended itself with status 0",), 3),
}


def has_landlock():
    libc = ctypes.CDLL(None, use_errno=True)
    return libc.syscall(444, None, 0, 1) >= 1


def state_of(folder):
    """All that lies below a folder, with contents, modes and links."""
    out = {}
    for path in sorted(folder.rglob("*")):
        info = path.lstat()
        text = path.read_bytes() if path.is_file() and not path.is_symlink() else b""
        out[str(path)] = (info.st_mode, info.st_ino, info.st_size, text)
    return out


class Untrusted(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        self.work = self.path / "work"
        self.outside = self.path / "outside"
        self.work.mkdir()
        self.outside.mkdir()
        (self.work / "part.nc").write_text(PART)
        (self.work / "hostile.xml").write_text(DIALECT)
        self.target = self.outside / "target"
        self.target.write_text("precious")

    def environment(self, deed=None, when=None, target=None):
        out = {k: v for k, v in os.environ.items() if not k.startswith(("ISOGLOSS_", "HOSTILE_"))}
        if deed is not None:
            out |= {"HOSTILE_DEED": deed, "HOSTILE_WHEN": when, "HOSTILE_TARGET": str(target or self.target)}
        return out

    def run_it(self, *arguments, environment=None, **more):
        more = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE} | more
        if "input" in more:
            del more["stdin"]
        return subprocess.run([OPTIONS.isogloss, *map(str, arguments)], cwd=self.work, check=False, errors="replace",
                              timeout=30 * OPTIONS.seconds, env=environment or self.environment(), **more)

    def hostile(self, deed, when, *more, command=("run", "part.nc"), target=None, **keywords):
        return self.run_it(*command, "-d", "hostile.xml", "--plugins", OPTIONS.hostile, *more,
                           environment=self.environment(deed, when, target), **keywords)

    # Hostile plugins

    def listening(self):
        server = socket.create_server(("127.0.0.1", 0))
        self.addCleanup(server.close)
        server.settimeout(0.2)
        return server

    def test_each_deed_is_refused_and_named_at_each_moment(self):
        server = self.listening()
        for deed, (call, _) in REFUSED.items():
            target = server.getsockname()[1] if deed == "connects" else self.target
            for when in MOMENTS if deed in ("creates", "connects", "forks", "kills_parent") else ("load", "build"):
                with self.subTest(deed, when=when):
                    before = state_of(self.path)
                    done = self.hostile(deed, when, "--untrusted", "-o", "out.jsonl", target=target)
                    self.assertEqual(done.returncode, 3, done.stderr)
                    self.assertIn(f"the work tried what --untrusted forbids, and was ended: {call}", done.stderr)
                    self.assertIn("[IG-0681]", done.stderr)
                    self.assertNotIn("succeeded", done.stderr)
                    self.assertNotIn("failed", done.stderr)
                    self.assertEqual(state_of(self.path), before)
        with self.assertRaises(TimeoutError):
            server.accept()

    def test_the_path_that_was_tried_is_named(self):
        for deed in ("creates", "removes", "changes_mode"):
            with self.subTest(deed):
                self.assertIn(f"({self.target})", self.hostile(deed, "load", "--untrusted").stderr)

    def test_the_same_deeds_succeed_without_untrusted(self):
        server = self.listening()
        for deed, (_, is_harmless) in REFUSED.items():
            if not is_harmless:
                continue
            with self.subTest(deed):
                self.target.write_text("precious")
                for other in self.outside.glob("*.hostile"):
                    other.unlink()
                target = server.getsockname()[1] if deed == "connects" else self.target
                done = self.hostile(deed, "load", "-o", "/dev/null", target=target)
                self.assertIn(f"hostile: {deed} succeeded", done.stderr)
                if deed in ("creates", "truncates", "writes_by_old_call", "starts", "forks", "removes", "renames"):
                    self.assertNotEqual(self.target.read_text() if self.target.exists() else "", "precious")

    def test_a_deed_at_the_end_of_the_process_is_refused(self):
        before = state_of(self.path)
        done = self.hostile("creates", "destroy", "--untrusted")
        self.assertNotIn("succeeded", done.stderr)
        self.assertEqual(state_of(self.path), before)

    def test_limits_end_the_work_and_name_what_was_used_up(self):
        for deed, (when, texts, status) in ENDED.items():
            if OPTIONS.sanitized and deed in ("starts_threads", "hides_threads"):
                continue  # the sanitizer itself watches threads by calls of its own
            with self.subTest(deed):
                before = state_of(self.path)
                begin = time.monotonic()
                done = self.hostile(deed, when, "--untrusted", "--max-time", "2", "--max-output", "1000",
                                    "--watchdog", "0", "-o", "out.jsonl")
                self.assertEqual(done.returncode, status, done.stderr[-500:])
                self.assertTrue(any(text in done.stderr for text in texts), done.stderr[-500:])
                self.assertIn("[IG-0683]" if status == 3 else "[IG-0682]", done.stderr)
                self.assertLess(time.monotonic() - begin, 6 * OPTIONS.seconds)
                self.assertEqual(state_of(self.path), before)

    def test_an_end_without_a_word_is_told(self):
        done = self.hostile("closes_output", "load", "--untrusted")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("it ended with status 2 and without a word; no output file was written [IG-0683]", done.stderr)
        # What goes to a file is whole, and diagnostics have their own.
        done = self.hostile("closes_output", "load", "--untrusted", "-o", "out.jsonl", "--diagnostics-output", "said.txt")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn('"Event":"end"', (self.work / "out.jsonl").read_text())

    def test_memory_is_limited(self):
        done = self.hostile("allocates", "build", "--untrusted", "--max-memory", "200", "-o", "out.jsonl")
        self.assertTrue(done.returncode in (1, 3), done.stderr)
        self.assertRegex(done.stderr, r"it needed more than 200 MiB of memory|hostile: allocates failed")
        if done.returncode == 1:
            self.assertIn("[IG-0682]", done.stderr)
            self.assertFalse((self.work / "out.jsonl").exists())

    def test_memory_is_counted_where_the_first_thread_has_ended(self):
        if OPTIONS.sanitized:
            self.skipTest("the sanitizer itself watches threads by calls of its own")
        done = self.hostile("ends_first_thread_and_allocates", "build", "--untrusted", "--max-memory", "200", "--watchdog", "0")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("it needed more than 200 MiB of memory", done.stderr)

    def test_limits_hold_while_nobody_reads_what_is_printed(self):
        process = subprocess.Popen([OPTIONS.isogloss, "run", "part.nc", "-d", "hostile.xml", "--plugins", OPTIONS.hostile,
                                    "--untrusted", "--max-memory", "200", "--watchdog", "0"], cwd=self.work,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   env=self.environment("prints_and_allocates", "build"))
        self.addCleanup(process.kill)
        children = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children")
        self.assertTrue(self.becomes(lambda: children.read_text() != ""))
        self.assertTrue(self.becomes(lambda: children.read_text() == ""))
        self.assertIsNone(process.poll())
        out, said = process.communicate(timeout=30 * OPTIONS.seconds)
        self.assertGreater(len(out), 0)
        self.assertEqual(process.returncode, 1, said)
        self.assertIn(b"it needed more than 200 MiB of memory", said)

    def becomes(self, is_so):
        for _ in range(100 * OPTIONS.seconds):
            if is_so():
                return True
            time.sleep(0.1)
        return False

    def test_a_smaller_limit_of_the_caller_stays(self):
        seconds = OPTIONS.seconds // 10
        done = self.hostile("loops_without_watch", "build", "--untrusted", "--max-time", 30 * seconds, "--watchdog", "0",
                            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1)))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(f"it used more than {seconds} s of the processor (a limit of whoever has called)", done.stderr)

    def test_the_watchdog_works_inside(self):
        done = self.hostile("loops", "build", "--untrusted", "--watchdog", "1")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("no end of the block in sight in BadSyntax of plugin hostile", done.stderr)
        self.assertEqual(sorted(p.name for p in self.work.iterdir()), ["hostile.xml", "part.nc"])

    def test_a_crash_writes_no_reproducer(self):
        bad = self.hostile("calls_by_interrupt", "build", "--untrusted")
        if os.uname().machine == "x86_64":
            self.assertEqual(bad.returncode, 3, bad.stderr)
            self.assertIn("[IG-0683]", bad.stderr)
        self.assertEqual(sorted(p.name for p in self.work.iterdir()), ["hostile.xml", "part.nc"])

    def test_descriptors_of_the_caller_are_closed(self):
        for options, text in ((("--untrusted",), "failed (Bad file descriptor)"), ((), "succeeded")):
            with self.subTest(options), open(self.target, "w", encoding="utf-8") as file:
                number = fcntl.fcntl(file.fileno(), fcntl.F_DUPFD, 100)
                done = self.hostile("writes_inherited", "load", *options, "-o", "/dev/null", target=number, pass_fds=[number])
                os.close(number)
                self.assertIn(f"hostile: writes_inherited {text}", done.stderr)
            self.assertEqual(self.target.read_text(), "" if options else "hostile\n")

    @unittest.skipUnless(has_landlock(), "this kernel has no Landlock")
    def test_reading_is_confined_to_the_named_folders(self):
        (self.work / "link").symlink_to(self.target)
        for path, real in ((self.target, None), ("/etc/passwd", None), (f"/proc/{os.getpid()}/environ", None),
                           (f"{self.work}/../outside/target", self.target), ("/proc/self/root/etc/passwd", "/etc/passwd"),
                           (self.work / "link", self.target), ("../outside/target", self.target), ("/dev/zero", None)):
            with self.subTest(path):
                done = self.hostile("reads", "load", "--untrusted", "-o", "out.jsonl", target=path)
                self.assertEqual(done.returncode, 3, done.stderr)
                self.assertIn(f"was ended: openat ({real or path}) [IG-0681]", done.stderr)
                self.assertFalse((self.work / "out.jsonl").exists())
                self.assertIn("hostile: reads succeeded", self.hostile("reads", "load", target=path).stderr)
        done = self.hostile("reads", "load", "--untrusted", target=self.work / "part.nc")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("hostile: reads succeeded", done.stderr)

    @unittest.skipUnless(has_landlock(), "this kernel has no Landlock")
    def test_links_beside_plugins_are_followed_to_plugins_alone(self):
        plugins, dialects, machines = (self.work / name for name in ("plugins", "dialects", "machines"))
        for folder in (plugins, dialects, machines):
            folder.mkdir()
        (plugins / "hostile.so").symlink_to(pathlib.Path(OPTIONS.hostile) / "hostile.so")
        (self.outside / "machine").mkdir()
        (self.outside / "machine" / "machine.xml").write_text('<Machine xmlns="urn:isogloss:dialect:1" name="machine" dialect="iso"/>')
        (self.outside / "some.xml").write_text(DIALECT)
        for number, (link, real, is_read) in enumerate((
                (plugins / "a.so", self.target, False), (plugins / "a", self.outside, False),
                (dialects / "a.xml", self.target, False), (dialects / "b.xml", self.outside / "some.xml", True),
                (machines / "a", self.outside, False), (machines / "b", self.outside / "machine", True))):
            link.symlink_to(real)
            target = {self.outside: self.target, self.outside / "machine": real / "machine.xml"}.get(real, real)
            with self.subTest(link):
                done = self.run_it("run", "part.nc", "-d", "hostile.xml", "--plugins", plugins, "--dialects", dialects,
                                   "--machines", machines, "--untrusted", "-o", f"out{number}",
                                   environment=self.environment("reads", "load", target))
                self.assertEqual("hostile: reads succeeded" in done.stderr, is_read, done.stderr)
                self.assertEqual(done.returncode, 0 if is_read else 3, done.stderr)
            link.unlink()
        machines.rmdir()
        (dialects / "machines").symlink_to(self.outside)
        done = self.run_it("run", "part.nc", "-d", "hostile.xml", "--plugins", plugins, "--dialects", dialects, "--untrusted",
                           environment=self.environment("reads", "load", self.target))
        self.assertIn(f"was ended: openat ({self.target}) [IG-0681]", done.stderr)
        done = self.run_it("run", "part.nc", "-m", "b", "-d", "iso", "--dialects", dialects, "--untrusted")
        self.assertIn(f"was ended: openat ({self.outside}) [IG-0681]", done.stderr)
        (self.outside / "b").mkdir()
        (self.outside / "machine" / "machine.xml").rename(self.outside / "b" / "machine.xml")
        done = self.run_it("run", "part.nc", "-m", "b", "--machines", dialects / "machines", "--untrusted")
        self.assertEqual(done.returncode, 0, done.stderr)

    @unittest.skipUnless(has_landlock(), "this kernel has no Landlock")
    def test_the_kernel_refuses_what_the_watch_lets_pass(self):
        """A library elsewhere is not reported, since the loader looks for some in many places; it is not read either."""
        library = self.outside / "library.so"
        library.write_text("precious")
        done = self.hostile("reads", "load", "--untrusted", target=library)
        self.assertIn("hostile: reads failed (Permission denied)", done.stderr)
        self.assertIn("hostile: reads succeeded", self.hostile("reads", "load", target=library).stderr)

    def test_where_reading_cannot_be_confined_it_is_said(self):
        done = self.run_it("run", "part.nc", "-d", "iso", "--untrusted")
        self.assertEqual("[IG-0684]" in done.stderr, not has_landlock())

    def test_a_terminal_is_written_text_alone(self):
        for options in (("--untrusted",), ()):
            master, slave = pty.openpty()
            process = subprocess.Popen([OPTIONS.isogloss, "run", "part.nc", "-d", "hostile.xml", "--plugins", OPTIONS.hostile,
                                        "-o", "/dev/null", *options], cwd=self.work, stdin=slave, stdout=slave, stderr=slave,
                                       env=self.environment("takes_hold_of_terminal", "load"))
            os.close(slave)
            text = b""
            while True:
                try:
                    part = os.read(master, 4096)
                except OSError:  # the other end is closed
                    break
                if not part:
                    break
                text += part
            process.wait()
            os.close(master)
            self.assertEqual(b"\033" in text, not options, text)
            if options:
                self.assertIn(b"\\x1b]0;hostile\\x07\\x1b[2J\\x9b2J\\x0dhostile\r\n", text)

    def test_an_output_that_is_a_terminal_gets_text_alone(self):
        for options in (("--untrusted",), ()):
            with self.subTest(options):
                master, slave = pty.openpty()
                done = self.hostile("prints_a_result", "build", "-o", os.ttyname(slave), *options, target="\x1b(Bhostile")
                self.assertEqual(done.returncode, 0, done.stderr)
                os.set_blocking(master, False)
                text = os.read(master, 1 << 16)
                os.close(slave)
                os.close(master)
                self.assertIn(b"hostile", text)
                self.assertEqual(b"\x1b" in text, not options, text)

    def test_an_output_that_is_a_pipe_gets_the_same_bytes(self):
        demo, got = PROGRAMS / "fanuc" / "demo.nc", []
        os.mkfifo(self.work / "pipe")
        for options in (("--untrusted",), ()):
            reader = subprocess.Popen(["cat", "pipe"], cwd=self.work, stdout=subprocess.PIPE)
            done = self.run_it("run", demo, "-d", "fanuc", "-o", "pipe", *options)
            got.append((done.returncode, done.stdout, done.stderr, reader.communicate()[0]))
        self.assertEqual(got[0], got[1])
        self.assertIn(b'"feed"', got[0][3])
        done = self.run_it("run", demo, "-d", "fanuc", "-o", "/dev/full", "--untrusted")
        self.assertEqual(done.returncode, 2)
        self.assertIn("/dev/full", done.stderr)
        self.assertIn("[IG-0511]", done.stderr)

    def test_a_binary_stream_is_not_for_a_terminal(self):
        master, slave = pty.openpty()
        done = self.run_it("run", "part.nc", "-d", "iso", "--format", "binary", "--untrusted", stdout=slave)
        os.close(slave)
        os.close(master)
        self.assertEqual(done.returncode, 2)
        self.assertIn("--format binary is not for a terminal", done.stderr)

    # Hostile programs

    def test_programs_end(self):
        programs = {
            "endless.nc": "N1 G0 X1.\nGOTO 1\nM30\n",
            "paths.nc": "M98 P../../etc/passwd\nM98 <../outside/target>\nG65 P/etc/passwd\nM30\n",
            "nesting.nc": "#1=" + "[" * 100_000 + "1" + "]" * 100_000 + "\nM30\n",
            "large.nc": "#1=0\nWHILE[#1LT10000000]DO1\nG1X#1F100.\n#1=#1+1\nEND1\nM30\n",
            "bytes.nc": "\0\1\2\ufffd" * 1000,
        }
        for name, text in programs.items():
            with self.subTest(name):
                (self.work / name).write_text(text)
                before = state_of(self.path)
                done = self.run_it("run", name, "-d", "fanuc", "--untrusted", "--max-output", "100000", "--max-jumps", "10000",
                                   "-o", "out.jsonl", "--max-time", 20 * OPTIONS.seconds)
                (self.work / "out.jsonl").unlink(missing_ok=True)
                self.assertIn(done.returncode, (0, 1, 2), done.stderr[-500:])
                self.assertNotIn("precious", done.stderr)
                self.assertNotIn("IG-0683", done.stderr)
                self.assertEqual(state_of(self.path), before)

    def test_what_was_printed_before_the_end_is_a_beginning_of_the_whole(self):
        # The plugin wakes at the first X. Up to 16,384 events wait to be written, and are lost with the process.
        (self.work / "late.nc").write_text("G90 G54 G21 G17 G94 F100.\n" + "G1 Y1.\nY2.\n" * 25_000 + "X1.\nM30\n")
        whole = self.run_it("run", "late.nc", "-d", "iso").stdout
        done = self.hostile("creates", "build", "--untrusted", command=("run", "late.nc"))
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertGreater(len(done.stdout), len(whole) // 2)
        self.assertTrue(whole.startswith(done.stdout))

    # Sound programs

    def both(self, *arguments, **more):
        plain = self.run_it(*arguments, **more)
        confined = self.run_it(*arguments, "--untrusted", **more)
        self.assertEqual(confined.returncode, plain.returncode, confined.stderr)
        self.assertEqual(confined.stdout, plain.stdout)
        self.assertEqual(confined.stderr, plain.stderr)
        return plain

    def test_a_sound_program_gives_the_same_bytes(self):
        demo, tools = PROGRAMS / "fanuc" / "demo.nc", PROGRAMS / "fanuc" / "tools.xml"
        for options in ((), ("--emit", "blocks"), ("--format", "csv"), ("--format", "text"), ("--summary",),
                        ("--summary", "--json", "--emit", "motions"), ("--emit", "none", "--diagnostics", "json"),
                        ("--diagnostics", "sarif", "--emit", "none"), ("--werror",)):
            with self.subTest(options):
                self.both("run", demo, "-d", "fanuc", "--tools", tools, *options)
        for command in (("explain", f"{demo}:12"), ("state", f"{demo}:12"), ("plot", demo), ("view", self.to_view()),
                        ("diff", "-a", "fanuc", "-b", "syntec", demo)):
            with self.subTest(command):
                self.both(*command, *(() if command[0] == "diff" else ("-d", "fanuc")), "--tools", tools)

    def to_view(self):
        """A view explains each block, for which a program of 60 takes 5 s under sanitizers."""
        if FACTOR >= 1:
            return PROGRAMS / "fanuc" / "demo.nc"
        (self.work / "short.nc").write_text("G21 G90 G54\nG00 X1. Y2. Z3.\nG01 X5. F100.\nM30\n")
        return self.work / "short.nc"

    def test_every_output_is_a_file_with_the_same_bytes(self):
        demo = PROGRAMS / "fanuc" / "demo.nc"
        found = []
        for options in ((), ("--untrusted",)):
            out = self.path / f"out{len(found)}"
            out.mkdir()
            run = ("-d", "fanuc", "--tools", PROGRAMS / "fanuc" / "tools.xml", "--diagnostics-output", out / "said", *options)
            for more in (("-o", out / "motions", "--save-table", f"MacroVariables={out / 'variables'}"),
                         ("--format", "binary", "-o", out / "binary"), ("--emit", "canonical", "-o", out / "canonical")):
                done = self.run_it("run", demo, *run, *more)
                self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(self.run_it("plot", demo, *run, "-o", out / "plot.svg").returncode, 0)
            self.assertEqual(self.run_it("view", self.to_view(), *run, "-o", out / "view.html").returncode, 0)
            found.append({path.name: (path.read_bytes(), path.stat().st_mode) for path in out.iterdir()})
        self.assertEqual(sorted(found[0]), ["binary", "canonical", "motions", "plot.svg", "said", "variables", "view.html"])
        self.assertEqual(found[0], found[1])

    def test_standard_input_is_read_from_a_file_and_from_a_pipe(self):
        text = (PROGRAMS / "fanuc" / "demo.nc").read_text()
        for command in (("run", "-"), ("plot", "-"), ("state", "-:12")):
            with self.subTest(command):
                self.both(*command, "-d", "fanuc", input=text)
                with open(PROGRAMS / "fanuc" / "demo.nc", encoding="utf-8") as file:
                    done = self.run_it(*command, "-d", "fanuc", "--untrusted", stdin=file)
                self.assertEqual(done.stdout, self.run_it(*command, "-d", "fanuc", input=text).stdout)
        # A jump back reads again what came through the pipe.
        again = "O1\n#1=0\nN1 G0 X#1\n#1=#1+1\n" + "(" + "x" * 1000 + ")\n" * 1 + "IF[#1LT3]GOTO1\nM30\n"
        self.both("run", "-", "-d", "fanuc", input=again)

    def test_called_programs_and_tables_are_found(self):
        (self.work / "main.nc").write_text("G21 G90\nM98 P1234\nM98 P77\nM30\n")
        (self.work / "O1234.nc").write_text("O1234\nG0 X1.\nM99\n")
        (self.outside / "O0077.nc").write_text("O0077\nG0 X2.\nM99\n")
        done = self.both("run", "main.nc", "-d", "fanuc", "--subprograms", self.outside)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.count('"rapid"'), 2)

    def test_machines_are_found(self):
        for machine in ("vmc850",):
            self.both("run", "part.nc", "-m", machine)

    def test_streams_in_one_file_keep_their_order(self):
        (self.work / "bad.nc").write_text("G21\nG1 X1. F100.\nG999\nX2.\nM30\n" * 3)
        texts = []
        for options in ((), ("--untrusted",)):
            with open(self.path / "both", "w+", encoding="utf-8") as file:
                self.run_it("run", "bad.nc", "-d", "iso", *options, stdout=file, stderr=file)
                file.seek(0)
                texts.append(file.read())
        self.assertEqual(texts[0], texts[1])
        self.assertIn("[ISO-0280]", texts[0])
        self.assertIn('"feed"', texts[0])

    def test_a_reader_that_goes_away_is_no_fault(self):
        (self.work / "long.nc").write_text("G21\n" + "G1 X1. F100.\nX2.\n" * 100_000)
        process = subprocess.Popen([OPTIONS.isogloss, "run", "long.nc", "-d", "iso", "--untrusted"], cwd=self.work,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=self.environment())
        self.assertIn('"feed"', process.stdout.readline())
        process.stdout.close()
        said = process.stderr.read()
        process.stderr.close()
        self.assertEqual(process.wait(), 0, said)
        self.assertEqual(said, "")

    def test_a_full_disk_is_reported(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = self.run_it("run", "part.nc", "-d", "iso", "--untrusted", stdout=full)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("[IG-0511]", done.stderr)

    def test_an_older_file_stays_where_the_work_is_ended(self):
        (self.work / "out.jsonl").write_text("older")
        done = self.hostile("creates", "build", "--untrusted", "-o", "out.jsonl")
        self.assertEqual(done.returncode, 3)
        self.assertEqual((self.work / "out.jsonl").read_text(), "older")
        self.assertEqual(sorted(p.name for p in self.work.iterdir()), ["hostile.xml", "out.jsonl", "part.nc"])

    def test_signals_end_both_processes(self):
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGKILL):
            with self.subTest(number):
                process = subprocess.Popen([OPTIONS.isogloss, "run", "part.nc", "-d", "hostile.xml", "--plugins",
                                            OPTIONS.hostile, "--untrusted", "-o", "out.jsonl", "--watchdog", "0"],
                                           cwd=self.work, env=self.environment("sleeps", "build"), stderr=subprocess.PIPE,
                                           text=True)
                self.assertEqual(process.stderr.readline(), "hostile: sleeps\n")
                child = int(pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text())
                process.send_signal(number)
                self.assertEqual(process.wait(6 * OPTIONS.seconds), -number)
                process.stderr.close()
                for _ in range(10 * OPTIONS.seconds):
                    if not pathlib.Path(f"/proc/{child}").exists():
                        break
                    time.sleep(0.1)
                self.assertFalse(pathlib.Path(f"/proc/{child}").exists())
                if number != signal.SIGKILL:
                    self.assertEqual(list(self.work.glob("out.jsonl*")), [])

    # Batches

    def test_a_batch_gives_it_to_each_program(self):
        (self.work / "archive").mkdir()
        for i in range(3):
            (self.work / "archive" / f"part{i}.nc").write_text(PART)
        plain = self.run_it("batch", "archive", "-d", "iso", "-o", "plain")
        done = self.run_it("batch", "archive", "-d", "iso", "-o", "confined", "--untrusted")
        self.assertEqual((plain.returncode, done.returncode), (0, 0), done.stderr)
        self.assertEqual((self.work / "plain" / "results.jsonl").read_bytes(),
                         (self.work / "confined" / "results.jsonl").read_bytes())
        before = state_of(self.outside)
        done = self.run_it("batch", "archive", "-d", "hostile.xml", "--plugins", OPTIONS.hostile, "-o", "hostile", "--untrusted",
                           environment=self.environment("creates", "load"))
        self.assertEqual(done.returncode, 3, done.stderr)
        results = [json.loads(line) for line in (self.work / "hostile" / "results.jsonl").read_text().splitlines()]
        self.assertEqual([r["Status"] for r in results], ["fault"] * 3)
        for result in results:
            self.assertIn("IG-0681", result["First"]["Message"])
        self.assertEqual(state_of(self.outside), before)

    def test_a_batch_itself_loads_no_plugin(self):
        """The files of a control that tables name are read by plugins."""
        (self.work / "backup.txt").write_text("%\nG10 L2 P1 X1. Y2. Z3.\n%\n")
        (self.work / "offsets.xml").write_text('<IsoCoordinateTable xmlns="urn:isogloss:dialect:1" src="backup.txt"/>')
        (self.work / "machine").mkdir()
        (self.work / "machine" / "machine.xml").write_text(
            '<Machine xmlns="urn:isogloss:dialect:1" name="machine" dialect="iso"><Backup src="backup.txt"/></Machine>')
        (self.work / "machine" / "backup.txt").write_text("%\nG10 L2 P1 X1. Y2. Z3.\n%\n")
        before = state_of(self.outside)
        for number, named in enumerate((("-d", "iso", "--offsets", "offsets.xml"), ("-d", "iso", "-m", "offsets.xml"),
                                        ("-m", "machine"), ("-d", "hostile.xml"), ())):
            for more in ((), ("--slurm", "1", "--no-submit")):
                with self.subTest(named, more=more):
                    batch = ("batch", "part.nc", *named, *more, "--plugins", OPTIONS.hostile, "-o", f"out{number}{len(more)}")
                    done = self.run_it(*batch, "--untrusted", environment=self.environment("creates", "load"))
                    self.assertEqual(done.returncode, 0 if more or not named else 3, done.stderr)
                    self.assertEqual(state_of(self.outside), before)
        self.run_it("batch", "part.nc", "-d", "iso", "--offsets", "offsets.xml", "--plugins", OPTIONS.hostile, "-o", "trusted",
                    environment=self.environment("creates", "load"))
        self.assertNotEqual(state_of(self.outside), before)

    def test_an_untrusted_batch_takes_no_program_for_a_list(self):
        (self.outside / "secret.nc").write_text(PART)
        (self.work / "strange.nc").write_text(f"{self.outside}/secret.nc\n")
        done = self.run_it("batch", "strange.nc", "-d", "iso", "-o", "out", "--untrusted")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("with --untrusted only --list takes a file for a list", done.stderr)
        for named in (("strange.nc",), ("--list", "strange.nc", "--untrusted")):
            done = self.run_it("batch", *named, "-d", "iso", "-o", "listed")
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_an_untrusted_batch_runs_again_what_a_file_of_a_control_changes(self):
        (self.work / "backup.txt").write_text("%\nG10 L2 P1 X1. Y2. Z3.\n%\n")
        (self.work / "offsets.xml").write_text('<IsoCoordinateTable xmlns="urn:isogloss:dialect:1" src="backup.txt"/>')
        (self.work / "machine.xml").write_text(
            '<Machine xmlns="urn:isogloss:dialect:1" name="machine" dialect="iso"><Backup src="backup.txt"/></Machine>')
        (self.work / "named.xml").write_text((self.work / "machine.xml").read_text())
        for number, named in enumerate((("-d", "iso", "--offsets", "offsets.xml"), ("-m", "machine.xml"), ("-m", "named.xml"))):
            with self.subTest(named):
                batch = ("batch", "part.nc", *named, "-o", f"out{number}", "--untrusted")
                done = self.run_it(*batch)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn("1 of 1 programs were finished before", self.run_it(*batch).stderr)
                with open(self.work / "backup.txt", "a", encoding="utf-8") as file:
                    file.write(f"(changed {number})\n")
                self.assertNotIn("were finished before", self.run_it(*batch).stderr)

    def test_a_result_that_a_plugin_made_up_does_a_batch_no_harm(self):
        (self.work / "archive").mkdir()
        for name in ("a.nc", "b.nc"):
            (self.work / "archive" / name).write_text(PART)
        rest = '"First": null, "Called": [], "Places": []}'
        for number, made_up in enumerate((
                '{"Summary": {"Program": 1, "Status": 5, "Dialect": 7, "Blocks": "<b>", "First": 3, "Diagnostics": '
                '{"Severity": 2, "Count": "x"}}, "First": {"File": 1, "Line": "x", "Message": {}, "Code": {}}, '
                '"Called": [["/proc/self/pagemap", ""], ["/etc/passwd", ""]], "Places": [["/", "", true]]}',
                '{"Summary": {"Status": 5}, ' + rest, '{"Summary": {"Deep": []}, ' + rest, "[]",
                '{"Summary": 1, "First": 2, "Called": 3, "Places": 0}', "{", "null", '"\\xff')):
            with self.subTest(number):
                out = f"made-up-{number}"
                for again in range(2):
                    done = self.run_it("batch", "archive", "-d", "hostile.xml", "--plugins", OPTIONS.hostile, "-o", out,
                                       "--untrusted", environment=self.environment("prints_a_result", "build", made_up))
                    self.assertIn(done.returncode, (0, 1, 3), done.stderr)
                    self.assertIn("2 programs", done.stderr)
                results = [json.loads(line) for line in (self.work / out / "results.jsonl").read_text().splitlines()]
                self.assertEqual([r["Program"] for r in results], ["archive/a.nc", "archive/b.nc"])
                self.assertEqual({type(r["Status"]) for r in results}, {str})
                for file in (self.work / out / "journal").iterdir():
                    self.assertNotIn("/etc/passwd", file.read_text())

    def test_a_result_of_a_million_names_ends_soon(self):
        begin = time.monotonic()
        done = self.run_it("batch", "part.nc", "-d", "hostile.xml", "--plugins", OPTIONS.hostile, "-o", "names", "--untrusted",
                           environment=self.environment("prints_many_names", "build"))
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertLess(time.monotonic() - begin, 6 * OPTIONS.seconds)

    def test_what_no_batch_can_confine_is_not_run(self):
        os.mkfifo(self.work / "pipe.nc")
        done = self.run_it("batch", "pipe.nc", "-d", "iso", "-o", "out", "--untrusted")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("[IG-0510]", done.stderr)
        self.assertFalse((self.work / "out").exists())

    def test_limits_of_a_batch_hold_for_what_is_confined(self):
        for deed, status in (("loops_without_watch", "out of time"), ("allocates", "out of memory")):
            with self.subTest(deed):
                done = self.run_it("batch", "part.nc", "-d", "hostile.xml", "--plugins", OPTIONS.hostile, "-o", deed,
                                   "--untrusted", "--max-time", 3 if deed != "allocates" else 20 * OPTIONS.seconds,
                                   "--max-memory", 300, environment=self.environment(deed, "build"))
                result = json.loads((self.work / deed / "results.jsonl").read_text())
                self.assertEqual(result["Status"], status, done.stderr)

    def test_time_in_which_all_were_stopped_does_not_count(self):
        """As a job that Slurm suspends, or a user."""
        if OPTIONS.sanitized:
            self.skipTest("the time without the stop would be too long")
        (self.work / "archive").mkdir()
        (self.work / "archive" / "part.nc").write_text(PART)
        named = ("-d", "hostile.xml", "--plugins", OPTIONS.hostile, "--max-time", "5")
        begun = [subprocess.Popen([OPTIONS.isogloss, *words, *named], cwd=self.work, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.PIPE, text=True, env=self.environment("naps", "build"))
                 for words in (("run", "part.nc", "--untrusted"), ("batch", "archive", "-o", "trusted"),
                               ("batch", "archive", "-o", "confined", "--untrusted"))]
        self.assertTrue(self.becomes(lambda: sum(len(self.below(p.pid)) for p in begun) >= 4))
        every = [p.pid for p in begun] + [pid for p in begun for pid in self.below(p.pid)]
        for number, seconds in ((signal.SIGSTOP, 8), (signal.SIGCONT, 0)):
            for pid in every:
                os.kill(pid, number)
            time.sleep(seconds)
        for process in begun:
            said = process.communicate(timeout=30 * OPTIONS.seconds)[1]
            self.assertEqual(process.returncode, 0, said)

    def below(self, process):
        children = pathlib.Path(f"/proc/{process}/task/{process}/children").read_text().split()
        return [int(c) for c in children] + [pid for c in children for pid in self.below(c)]

    # Wrong usage

    def test_commands_without_it_refuse_it(self):
        for command in (("lsp",), ("dap",), ("validate", "x.so"), ("schema", "dialect"), ("motions", "part.nc"), ("docs", "-o", "x"),
                        ("new", "machine", "x"), ("import", "part.nc"), ("manual",)):
            with self.subTest(command):
                before = state_of(self.path)
                done = self.run_it(*command, "--untrusted")
                self.assertEqual(done.returncode, 2)
                self.assertIn("no option '--untrusted'", done.stderr)
                self.assertEqual(state_of(self.path), before)

    def test_what_does_not_go_together_is_refused(self):
        for arguments, text in ((("view", "part.nc", "--serve", "--untrusted"), "--serve"),
                                (("run", "part.nc", "--max-time", "5"), "--max-time belongs to --untrusted"),
                                (("run", "part.nc", "--max-time", "600"), "--max-time belongs to --untrusted")):
            with self.subTest(arguments):
                done = self.run_it(*arguments)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn(text, done.stderr)

    def test_a_program_that_is_no_file_is_refused(self):
        os.mkfifo(self.work / "pipe")
        done = self.run_it("run", "pipe", "-d", "iso", "--untrusted")
        self.assertEqual(done.returncode, 2)
        self.assertIn("[IG-0685]", done.stderr)

    def test_without_a_filter_nothing_runs(self):
        """Inside of a filter with a listener of its own the kernel gives no second one."""
        if OPTIONS.sanitized:
            self.skipTest("the sanitizer does not start under the filter of this test")
        script = """
import ctypes, os, sys
seccomp = ctypes.CDLL("libseccomp.so.2")
seccomp.seccomp_init.restype = ctypes.c_void_p
context = ctypes.c_void_p(seccomp.seccomp_init(0x7fff0000))
# One call that nobody makes has a listener.
seccomp.seccomp_rule_add(context, 0x7fc00000, seccomp.seccomp_syscall_resolve_name(b"quotactl"), 0)
if seccomp.seccomp_load(context) != 0:
    sys.exit(77)
os.set_inheritable(seccomp.seccomp_notify_fd(context), True)
os.execv(sys.argv[1], sys.argv[1:])
"""
        before = state_of(self.path)
        def run(*arguments):
            done = subprocess.run([sys.executable, "-c", script, OPTIONS.isogloss, *arguments, "-d", "hostile.xml", "--plugins",
                                   str(OPTIONS.hostile), "--untrusted"], cwd=self.work, capture_output=True, text=True,
                                  check=False, env=self.environment("creates", "load"), timeout=30 * OPTIONS.seconds)
            if done.returncode == 77:
                self.skipTest("no filter can be set up here")
            self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
            return done.stderr
        self.assertIn("[IG-0680]", run("run", "part.nc"))
        self.assertEqual(state_of(self.path), before)
        run("batch", "part.nc", "-o", "out")
        result = json.loads((self.work / "out" / "results.jsonl").read_text())
        self.assertEqual(result["Status"], "not run")
        self.assertIn("IG-0680", result["First"]["Message"])


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True)
    parser.add_argument("--hostile", required=True)
    parser.add_argument("--seconds", type=int, default=10)
    parser.add_argument("--sanitized", action="store_true")
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.isogloss = str(pathlib.Path(OPTIONS.isogloss).resolve())
    OPTIONS.hostile = str(pathlib.Path(OPTIONS.hostile).resolve())
    unittest.main(argv=[sys.argv[0], *rest])
