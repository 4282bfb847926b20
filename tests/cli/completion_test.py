#!/usr/bin/env python3
"""What `isogloss complete` answers, and what bash, zsh and fish make of it when somebody presses Tab.

  completion_test.py --isogloss PATH --completions FOLDER --vendor FOLDER
"""
import argparse
import os
import pathlib
import pty
import re
import resource
import select
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

OPTIONS = None


def environment(**more):
    kept = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")}
    return kept | {"PATH": f"{OPTIONS.isogloss.parent}:{os.environ['PATH']}", "LC_ALL": "C.UTF-8"} | more


def answer(*words):
    done = subprocess.run([OPTIONS.isogloss, "complete", "--", *words], capture_output=True, text=True, timeout=60,
                          check=False, env=environment())
    assert done.returncode == 0 and done.stderr == "", (words, done)
    return done.stdout.splitlines()


def work_of_children():
    """Seconds of the processor: a busy machine takes its time, but the work is the same."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def texts(*words):
    return [line.split("\t")[0] for line in answer(*words)]


class Answers(unittest.TestCase):
    def test_commands_and_options(self):
        self.assertEqual(texts("r"), ["run"])
        self.assertIn("explain", texts(""))
        self.assertNotIn("complete", texts(""))
        self.assertEqual(texts("--vers"), ["--version"])
        self.assertEqual(texts("run", "--emi"), ["--emit"])
        self.assertIn("-d", texts("run", "-"))
        self.assertEqual(texts("nonsense", ""), [])

    def test_an_option_is_offered_once_unless_it_repeats(self):
        self.assertNotIn("--emit", texts("run", "--emit", "none", "--"))
        self.assertIn("--set", texts("run", "--set", "a=b", "--"))

    def test_values_follow_their_option(self):
        self.assertEqual(texts("run", "--emit", ""), ["blocks", "motions", "canonical", "none"])
        self.assertEqual(texts("run", "--emit=m"), ["motions"])
        self.assertEqual(texts("run", "-d", "fa"), ["fanuc", ":files *.xml"])
        self.assertEqual(texts("run", "part.nc", "--dialect=FA"), ["fanuc", ":files *.xml"])
        self.assertEqual(texts("run", "-m", "fanuc-"), ["fanuc-mill", ":files *.xml"])
        self.assertEqual(texts("run", "--plugins", ""), [":folders"])
        self.assertEqual(texts("run", "--offsets", ""), [":files *"])
        self.assertEqual(texts("run", "--max-blocks", ""), [])

    def test_operands(self):
        self.assertEqual(texts("run", ""), [":files *"])
        self.assertEqual(texts("run", "a.nc", ""), [":files *"], "it takes several")
        self.assertEqual(texts("run", "--", "-"), [":files *"])
        self.assertEqual(texts("new", "m"), ["machine"])
        self.assertEqual(texts("new", "plugin", ""), [], "a name is free")
        self.assertEqual(texts("explain", "IG-0206"), ["IG-0206", ":files *"])
        self.assertEqual(texts("explain", ""), [":files *"])
        self.assertIn("loads", texts("validate", "--only", ""))
        self.assertIn("HeidenhainToolTable", texts("import", "--format", "heid"))
        self.assertIn("--format", texts("export", ""), "it has no operand")

    def test_fields_and_headings(self):
        self.assertIn("Feedrate.FeedrateValue", texts("explain", "part.nc", "--field", "Feedr"))
        self.assertIn("Feedrate", texts("explain", "part.nc", "--field", "Feedr"), "a section is all of its fields")
        self.assertIn("Comment", texts("diff", "--ignore", "Comm"))
        self.assertEqual(texts("inspect", "DwellSyntax", "--section", "Diag"), ["Diagnostics"])

    def test_values_of_tables(self):
        self.assertEqual(texts("run", "-d", "fanuc", "--set", "IsoCoord"), ["IsoCoordinateTable.", ":open"])
        self.assertIn("IsoCoordinateTable.G54.", texts("run", "-d", "fanuc", "--set", "IsoCoordinateTable.G5"))
        self.assertEqual(texts("run", "--set", "IsoCoordinateTable.G54.Z"), ["IsoCoordinateTable.G54.Z=", ":open"])
        self.assertIn("ToolOffsetTable.7.", texts("state", "-m", "klartext-5axis", "--set", "ToolOffsetTable."))
        self.assertEqual(texts("run", "--set", "IsoCoordinateTable.G54.Z=1"), [])
        options = texts("import", "--format", "FanucOffsets", "--set", "un")
        self.assertEqual(options, ["unit=", ":open"])
        self.assertIn("unit=inch", texts("import", "--format", "FanucOffsets", "--set", "unit=i"))

    def test_names_of_plugins(self):
        self.assertEqual(texts("inspect", "drill"), ["DrillingCycleSyntax"], "small letters find it")
        self.assertIn("FanucParameterTable", texts("inspect", "Fanuc"))
        self.assertIn("Feedrate.FeedrateValue", texts("inspect", "Feedrate."))
        self.assertNotIn("G83", texts("inspect", "G8"))
        self.assertIn("G83", texts("inspect", "-d", "fanuc", "G8"))
        self.assertIn("G83", texts("inspect", "-m", "fanuc-mill", "G8"))
        self.assertEqual(texts("inspect", "-d", "nonsense", "G83"), [], "and nothing is said")

    def test_a_vendors_dialects(self):
        self.assertNotIn("acme", texts("run", "-d", "ac"))
        self.assertIn("acme", texts("run", "--dialects", str(OPTIONS.vendor), "-d", "ac"))
        self.assertIn("acme", texts(f"--dialects={OPTIONS.vendor}", "run", "-d", "ac"))

    def test_descriptions_stand_behind_a_tab(self):
        self.assertEqual(answer("r"), ["run\trun programs through a dialect: motions, blocks, a summary"])

    def test_it_is_fast(self):
        for words in (("run", "-d", ""), ("inspect", "-d", "fanuc", "G8"), ("explain", "IG-0")):
            seconds = []
            while not seconds or (len(seconds) < 20 and min(seconds) > OPTIONS.seconds):
                begin = work_of_children()
                answer(*words)
                seconds.append(work_of_children() - begin)
            self.assertLessEqual(min(seconds), OPTIONS.seconds, words)


class Shells(unittest.TestCase):
    """Tab is pressed in a real shell on a terminal; the line that it leaves is echoed."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name).resolve()
        (self.path / "my part.nc").write_text("")
        (self.path / "own.xml").write_text("")
        (self.path / "plugs").mkdir()
        (self.path / "plugs/acme.so").write_text("")

    def lines(self, command, setup, typed):
        """What each of the typed lines has become when Enter is pressed."""
        child, terminal = pty.fork()
        if child == 0:
            os.chdir(self.path)
            os.execvpe(command[0], command, environment(HOME=str(self.path), TERM="xterm", HISTFILE="/dev/null"))
        output = ""

        def wait_for(mark):
            nonlocal output
            end = time.monotonic() + 60
            while not re.search(mark, output):
                if not select.select([terminal], [], [], max(0.0, end - time.monotonic()))[0]:
                    self.fail(f"{command[0]} does not answer: {output!r}")
                try:
                    output += os.read(terminal, 65536).decode(errors="replace")
                except OSError:
                    self.fail(f"{command[0]} ended: {output!r}")

        out = []
        try:
            for number, line in enumerate([setup, *(line + "\t\x01echo 'LINE'; echo " for line in typed)]):
                output = ""
                os.write(terminal, f"{line}\r".encode())
                os.write(terminal, f"echo D'ONE'{number}\r".encode())
                wait_for(rf"[\r\n]DONE{number}\r")
                out.append(re.search(r"[\r\n]LINE\r+\n(?:\x1b\S*)*([^\r\n]*)\r", output))
        finally:
            os.close(terminal)
            os.waitpid(child, 0)
        return [found and found[1].strip() for found in out[1:]]

    typed = {
        "isogloss expl": "isogloss explain",
        "isogloss run -d fanu": "isogloss run -d fanuc",
        "isogloss run --dialect=fanu": "isogloss run --dialect=fanuc",
        "isogloss run my": "isogloss run my part.nc",
        "isogloss lint ow": "isogloss lint own.xml",
        "isogloss run --plugins plu": "isogloss run --plugins plugs/",
        "isogloss validate plugs/ac": "isogloss validate plugs/acme.so",
        "isogloss inspect drill": "isogloss inspect DrillingCycleSyntax",
        "isogloss inspect -d fanuc G68.2": "isogloss inspect -d fanuc G68.2",
        "isogloss explain IG-0206": "isogloss explain IG-0206",
        "isogloss run --summ": "isogloss run --summary",
        "isogloss run -d own": "isogloss run -d own.xml",
        "isogloss run --set IsoCoordinateTable.G54.Z": "isogloss run --set IsoCoordinateTable.G54.Z=",
        "isogloss import --set tool-rad": "isogloss import --set tool-radius=",
    }

    def check(self, command, setup):
        self.maxDiff = None
        # zsh takes a slash that it has added away again when the word ends there.
        seen = [line and line.rstrip("/") for line in self.lines(command, setup, list(self.typed))]
        self.assertEqual(dict(zip(self.typed, seen)), {line: done.rstrip("/") for line, done in self.typed.items()})

    def test_bash(self):
        self.check(["bash", "--norc", "--noprofile", "-i"], f"source {OPTIONS.completions}/isogloss.bash")

    def test_bash_lists_what_fits(self):
        script = (f"source {OPTIONS.completions}/isogloss.bash; COMP_WORDS=(isogloss run --dialect = ''); COMP_CWORD=4;"
                  "_isogloss isogloss '' =; printf '%s\\n' \"${COMPREPLY[@]}\"")
        done = subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=False, cwd=self.path,
                              env=environment())
        self.assertEqual(done.stdout.split()[:2] + done.stdout.split()[-2:], ["fanuc", "haas", "plugs", "own.xml"])

    def test_zsh(self):
        if shutil.which("zsh") is None:
            self.skipTest("zsh is not installed")
        self.check(["zsh", "-f", "-i"], f"fpath=({OPTIONS.completions} $fpath); autoload -Uz compinit; compinit -D -u")

    def test_fish(self):
        if shutil.which("fish") is None:
            self.skipTest("fish is not installed")
        for line, completed in self.typed.items():
            script = f"source {OPTIONS.completions}/isogloss.fish; complete -C '{line}'"
            done = subprocess.run(["fish", "--no-config", "-c", script], capture_output=True, text=True, check=False,
                                  cwd=self.path, env=environment(HOME=str(self.path)))
            seen = [found.split("\t")[0] for found in done.stdout.splitlines()]
            self.assertEqual(seen, [completed.split(" ", 2 if "my part" in completed else -1)[-1]], (line, done.stderr))


def main():
    global OPTIONS
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--isogloss", type=pathlib.Path, required=True)
    arguments.add_argument("--completions", type=pathlib.Path, required=True)
    arguments.add_argument("--vendor", type=pathlib.Path, required=True)
    arguments.add_argument("--seconds", type=float, default=0.1, help="what an answer may take")
    OPTIONS, rest = arguments.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])


main()
