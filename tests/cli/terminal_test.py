#!/usr/bin/env python3
"""What differs between a terminal and a pipe: width, colours, progress; and names that are wrong by a letter."""
import argparse
import fcntl
import os
import pathlib
import pty
import re
import struct
import subprocess
import sys
import tempfile
import termios
import threading
import time
import unittest
import xml.etree.ElementTree as ElementTree

OPTIONS = None
ESCAPE = re.compile(r"\x1b\[[0-9;]*[A-Za-z]")


def environment(**more):
    kept = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_") and k not in ("COLUMNS", "NO_COLOR")}
    return {**kept, "TERM": "xterm", **more}


def in_pipe(*arguments, **more):
    return subprocess.run([OPTIONS.isogloss, *map(str, arguments)], capture_output=True, text=True, check=False,
                          timeout=120, env=environment(**more))


def feed(pipe, seconds):
    """A program that goes on for so long."""
    lines, end = b"".join(b"G1 X%d.5\n" % i for i in range(1000)), time.monotonic() + seconds
    try:
        pipe.write(b"G21 G90 F100\n")
        while time.monotonic() < end:
            pipe.write(lines)
            pipe.flush()
            time.sleep(0.02)
        pipe.close()
    except BrokenPipeError:
        pass


def on_terminal_for_long(program, *arguments, **more):
    """The same of a command that is long enough to tell how far it is: on a machine that has become less busy since the
    program was written, the command is repeated with twice as much of it. LAST: the number of its last line."""
    for _ in range(4):
        head, *lines, end = program.read_text().splitlines(keepends=True)
        begin = time.monotonic()
        result = on_terminal(*(str(a).replace("LAST", str(len(lines) + 2)) for a in arguments), **more)
        if "%" in result[0] or time.monotonic() - begin > 4:
            break
        program.write_text("".join([head, *lines, *lines, end]))
    return result


def on_terminal(*arguments, columns=80, slow=0, stdout_too=True, **more):
    """Everything that the terminal gets, and the exit status. `slow`: seconds before standard input ends."""
    main, other = pty.openpty()
    fcntl.ioctl(other, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    child = subprocess.Popen([OPTIONS.isogloss, *map(str, arguments)], stdin=subprocess.PIPE,
                             stdout=other if stdout_too else subprocess.DEVNULL, stderr=other, env=environment(**more))
    os.close(other)
    feeder = threading.Thread(target=feed, args=(child.stdin, slow))
    feeder.start()
    text = b""
    while True:
        try:
            got = os.read(main, 65536)
        except OSError:  # the last descriptor of the other side is closed
            break
        if not got:
            break
        text += got
    os.close(main)
    status = child.wait(timeout=60)
    feeder.join()
    child.stdin.close()
    return text.decode().replace("\r\n", "\n"), status


class Widths(unittest.TestCase):
    def widest(self, text):
        lines = text.split("\nExample")[0].splitlines()
        return max((len(line) for line in lines if " " in line.strip()), default=0)

    def test_help_fits_every_terminal(self):
        commands = re.findall(r"^  (\w+) ", in_pipe("--help").stdout.split("Options")[0], re.M)
        self.assertGreater(len(commands), 10)
        for columns in (60, 80, 132, 200):
            for command in commands:
                with self.subTest(f"{command}, {columns} columns"):
                    text, status = on_terminal(command, "--help", columns=columns)
                    self.assertEqual(status, 0)
                    self.assertLessEqual(self.widest(text), columns, text)
                    self.assertIn("Example", text)
            text, _ = on_terminal("--help", columns=columns)
            self.assertLessEqual(self.widest(text), columns, text)

    def test_nothing_is_lost_in_a_narrow_one(self):
        wide = in_pipe("run", "--help").stdout
        narrow, _ = on_terminal("run", "--help", columns=60)
        self.assertEqual(narrow.split(), wide.split())
        self.assertGreater(self.widest(wide), 80, "a pipe has no width")

    def test_a_terminal_is_taken_for_60_to_200_columns(self):
        for real, taken in ((20, 60), (500, 200)):
            text, _ = on_terminal("run", "--help", columns=real)
            same, _ = on_terminal("run", "--help", columns=taken)
            self.assertEqual(text, same)

    def test_columns_goes_over_the_terminal(self):
        text, _ = on_terminal("list", "syntaxes", columns=200, COLUMNS="70")
        self.assertLessEqual(self.widest(text), 70)
        self.assertEqual(in_pipe("list", "syntaxes", COLUMNS="70").stdout, text)
        self.assertEqual(in_pipe("list", "syntaxes", COLUMNS="wide").stdout, in_pipe("list", "syntaxes").stdout)

    def test_tables_fit(self):
        for what in ("syntaxes", "diagnostics", "fields", "dependencies"):
            whole = in_pipe("list", what).stdout
            for columns in (60, 100, 200):
                with self.subTest(f"{what}, {columns} columns"):
                    text, _ = on_terminal("list", what, columns=columns)
                    wide = [line for line in text.splitlines() if len(line) > columns and " " in line.strip()]
                    self.assertEqual(wide[:3], [], "only a word that is too long stays whole")
                    self.assertEqual(text.split(), whole.split())


    def test_a_declaration_fits(self):
        for name in ("Feedrate.Term", "fanuc"):
            with self.subTest(name):
                text, _ = on_terminal("inspect", name, columns=80)
                self.assertLessEqual(self.widest(text), 80, text)
                self.assertEqual(text.split(), in_pipe("inspect", name).stdout.split())


class Colours(unittest.TestCase):
    def test_only_a_terminal_has_them_and_no_color_takes_them_away(self):
        self.assertRegex(on_terminal("lint", "nothing")[0], r"\x1b\[1;31merror")
        self.assertNotIn("\x1b", in_pipe("lint", "nothing").stderr)
        self.assertNotIn("\x1b", on_terminal("lint", "nothing", NO_COLOR="1")[0])
        self.assertIn("\x1b", on_terminal("lint", "nothing", NO_COLOR="")[0])
        self.assertNotIn("\x1b", on_terminal("lint", "nothing", TERM="dumb")[0])


class ProgressLine(unittest.TestCase):
    def test_a_long_run_shows_it_and_takes_it_away(self):
        text, status = on_terminal("run", "-", "-d", "fanuc", "--emit", "none", slow=2.5)
        self.assertEqual(status, 0, text[-400:])
        self.assertRegex(text, r"-: \d+ blocks")
        shown = [part for part in re.split(r"\r\x1b\[K", text) if "blocks" in part]
        self.assertTrue(all(len(ESCAPE.sub("", part)) < 80 for part in shown), shown[:3])
        self.assertRegex(text, r"blocks\r\x1b\[K[^\r]*$", "it is gone before the last warning")

    def test_it_tells_how_much_of_a_file_is_done(self):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "long.nc"
            lines, seconds = 200_000, 0.0
            while seconds < 2 and lines < 20_000_000:  # on any machine
                lines = int(lines * max(2.0, min(8.0, 2.5 / max(seconds, 0.1))))
                program.write_text("G21 G90 G1 F100\n" + "X1.5 Y2.25\nX977.5\n" * (lines // 2) + "M30\n")
                begin = time.monotonic()
                in_pipe("run", program, "-d", "fanuc", "--emit", "none")
                seconds = time.monotonic() - begin
            text, _ = on_terminal_for_long(program, "run", program, "-d", "fanuc", "--emit", "none")
            self.assertRegex(text, r"\[#*\.*\] +\d+ %  .*long\.nc: \d+ blocks")
            piped = in_pipe("run", program, "-d", "fanuc", "--emit", "none")
            self.assertEqual((piped.stdout, piped.stderr), ("", ""))

    def test_explain_diff_and_state_show_it(self):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "long.nc"
            lines, seconds = 100_000, 0.0
            while seconds < 2.5 and lines < 20_000_000:  # on any machine
                lines = int(lines * max(1.5, min(8.0, 3.0 / max(seconds, 0.1))))
                program.write_text("G21 G90 G1 F100\n" + "X1.5 Y2.25\nX977.5\n" * (lines // 2) + "M30\n")
                begin = time.monotonic()
                in_pipe("explain", f"{program}:{lines}", "-d", "fanuc", "--brief")
                seconds = time.monotonic() - begin
            blocks, change = program.read_text().splitlines(keepends=True), ("--set-b", "FanucParameterTable.5115=5")
            # The others take longer for each line.
            for arguments, what, share in ((("explain", f"{program}:LAST", "--brief"), "blocks", 1),
                                           (("state", f"{program}:LAST"), "blocks", 3),
                                           (("diff", program, *change), "blocks compared", 6),
                                           (("diff", program, *change, "--motions"), "blocks compared", 4)):
                with self.subTest(arguments[0]):
                    program.write_text("".join(blocks[:len(blocks) // share]))
                    for columns in (60, 200) if share == 1 else (60,) if share == 4 else (200,):
                        text, status = on_terminal_for_long(program, *arguments, "-d", "fanuc", columns=columns)
                        self.assertEqual(status, 0, text[-400:])
                        shown = [p for p in re.split(r"\r\x1b\[K", text) if "] " in p and p.startswith("[")]
                        self.assertTrue(shown, text[:400])
                        self.assertRegex(shown[0], r"^\[#*\.*\] +\d+ %  .*" + ("" if columns == 60 else what))
                        self.assertTrue(all(len(ESCAPE.sub("", p)) < columns for p in shown), shown[:3])
                        self.assertNotRegex(text.split("\r\x1b[K")[-1], r"^\[#", "it is gone at the end")
                    last = str(program.read_bytes().count(b"\n"))
                    piped = in_pipe(*(str(a).replace("LAST", last) for a in arguments), "-d", "fanuc")
                    self.assertNotIn("\x1b", piped.stdout + piped.stderr)
                    self.assertNotIn("blocks compared", piped.stderr)

    def test_a_short_command_and_data_on_the_terminal_show_none(self):
        self.assertNotIn("\r\x1b[K", on_terminal("lint", "iso", "--repeats", "1")[0].split("syntaxes")[1])
        text, _ = on_terminal("run", "-", "-d", "fanuc", slow=2.2)
        self.assertNotIn("\x1b[K", text)
        text, _ = on_terminal("run", "-", "-d", "fanuc", slow=2.2, stdout_too=False)
        self.assertIn("\x1b[K", text, "data goes elsewhere: the terminal is free")

    def test_long_checks_show_it(self):
        begin = time.monotonic()
        text, _ = on_terminal("lint", *["fanuc"] * 60)
        if time.monotonic() - begin > 2:
            self.assertRegex(text, r"\r\x1b\[K\[#*\.*\] +\d+ %  fanuc")
        self.assertEqual(len(re.findall(r"(?:^|\r\x1b\[K)fanuc: ", text, re.M)), 60)


class Names(unittest.TestCase):
    """Each name that is wrong by a letter has its hint."""

    def meant(self, near, *arguments, status=2):
        done = in_pipe(*arguments)
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertRegex(done.stderr, rf"did you mean '?{re.escape(near)}'?\?")

    def test_on_the_command_line(self):
        self.meant("run", "rnu")
        self.meant("--emit", "run", "a.nc", "--emti", "none")
        self.meant("--emit", "run", "a.nc", "--emti=none")
        self.meant("--all", "case", "--al")
        self.meant("motions", "run", "a.nc", "--emit", "motins")
        self.meant("syntaxes", "list", "syntaxe")
        self.meant("dialect", "schema", "dialec")
        self.meant("fanuc", "lint", "fanu", status=1)
        self.meant("fanuc-mill", "lint", "-m", "fanuc-mil")
        self.meant("DwellSyntax", "inspect", "DwelSyntax")
        self.meant("Feedrate.Term", "inspect", "Feedrate.Tem")
        self.meant("G68.2", "inspect", "G68.22", "-d", "fanuc")
        self.assertIn("is one operand too many", in_pipe("schema", "block", "twice").stderr)
        self.assertIn("no option '-q'", in_pipe("schema", "block", "-q").stderr)

    def test_of_tables(self):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "a.nc"
            program.write_text("M30\n")
            run = ("run", program, "-d", "fanuc")
            self.meant("IsoCoordinateTable.G54.Z", *run, "--set", "IsoCordinateTable.G54.Z=1")
            self.meant("CornerRadius", *run, "--set", "ToolOffsetTable.1.CornerRadus=1")
            self.meant("MacroVariables", *run, "--save-table", f"MacroVariable={folder}/x.xml", status=1)

    def test_in_files(self):
        for near, text in (("iso", '<Plugins><Plugin name="isso"/></Plugins>'),
                           ("DwellSyntax", '<Chain><Configure syntax="DwelSyntax" p-unit="s"/></Chain>'),
                           ("p-unit", '<Chain><Configure syntax="DwellSyntax" p-unti="s"/></Chain>'),
                           ("ms", '<Chain><Configure syntax="DwellSyntax" p-unit="mss"/></Chain>'),
                           ("Remove", '<Chain><Remov syntax="DwellSyntax"/></Chain>'),
                           ("ToolOffsetTable", "<Dependencies><ToolOfsetTable/></Dependencies>"),
                           ("Tool", '<Dependencies><ToolOffsetTable><Tol id="1"/></ToolOffsetTable></Dependencies>'),
                           ("warning", '<Severities><Severity code="IG-0212" is="warnin"/></Severities>'),
                           ("Feedrate.Term", '<Initial><Field path="Feedrate.Tem" value="G94"/></Initial>')):
            with self.subTest(text), tempfile.TemporaryDirectory() as folder:
                file = pathlib.Path(folder) / "x.xml"
                file.write_text(f'<Dialect xmlns="urn:isogloss:dialect:1" name="x" extends="fanuc">{text}</Dialect>')
                self.meant(near, "lint", file, status=1)

    def test_a_severity_of_a_diagnostic_that_nobody_declares(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "x.xml"
            head = '<Dialect xmlns="urn:isogloss:dialect:1" name="x" extends="iso"><Severities><Severity '
            file.write_text(head + 'code="ISO-03011" is="note"/></Severities></Dialect>')
            done = in_pipe("lint", file)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stderr, r"x\.xml:1:\d+: warning: .*'ISO-03011'.* changes nothing \[IG-0235\]")
            self.assertIn("did you mean ISO-", done.stderr)
            file.write_text(head + 'code="TAB-0112" is="note"/></Severities></Dialect>')  # of an importer
            self.assertNotIn("IG-0235", in_pipe("lint", file).stderr)


class JUnit(unittest.TestCase):
    def test_cases_are_test_cases(self):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "dwell_syntax.md"
            page.write_text('# DwellSyntax\n\n## A "wrong" <case>\n\n#BeforeBuild:\n```json\n{}\n```\n'
                            '#AfterBuild:\n```json\n{ "Dwell": { "Time": 1 } }\n```\n'
                            '## Right\n\n#BeforeBuild:\n```json\n{}\n```\n#AfterBuild:\n```json\n{}\n```\n')
            missing = pathlib.Path(folder) / "empty_syntax.md"
            missing.write_text("# NoSuchSyntax\n\nText.\n")
            done = in_pipe("case", page, missing, "--junit")
            self.assertEqual(done.returncode, 1)
            self.assertEqual(in_pipe("case", page, missing, "--format", "junit").returncode, 1)
            suites = ElementTree.fromstring(done.stdout)
            first, second = suites.findall("testsuite")
            self.assertEqual((first.get("name"), first.get("tests"), first.get("failures"), first.get("errors")),
                             (str(page), "2", "1", "0"))
            cases = first.findall("testcase")
            self.assertEqual([(c.get("classname"), c.get("name"), c.find("failure") is not None) for c in cases],
                             [("DwellSyntax", 'A "wrong" <case>', True), ("DwellSyntax", "Right", False)])
            self.assertIn("Dwell", cases[0].find("failure").text)
            self.assertGreater(int(second.get("errors")), 0, done.stdout)
            self.assertIn("IG-0", second.find("testcase/error").get("message"))


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True)
    OPTIONS, rest = parser.parse_known_args()
    OPTIONS.isogloss = str(pathlib.Path(OPTIONS.isogloss).resolve())
    unittest.main(argv=[sys.argv[0], *rest])
