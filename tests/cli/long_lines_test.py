#!/usr/bin/env python3
"""A line of the same words over and over takes a time that grows with its length, not with the square of it.

  long_lines_test.py --isogloss PATH [--seconds N]

Each line has 400,000 bytes. Where each word looks at all the others, it takes minutes of the processor; N seconds are allowed
(8), and each line takes a fraction of one.
"""
import argparse
import pathlib
import resource
import subprocess
import sys
import tempfile

BYTES = 400_000
WORDS = ["N1 ", "G1 ", "M1 ", "G1 N1 ", "N1M5 ", "G1 M777 ", "G999 ", "X1 ", "X ", "F1 ", "T1 ", "O1 ", "M98 P1 ", "G65 P1 A1 ",
         "#1=#1+", "#1 ", "X[", "X(", "( )", "(* *)", "/ ", "; ", ": ", ",R1 ", "<A> ", '"A" ', "A:", "A=1 ", "R1=1 ", "1,", "_",
         "*", "Q1=", "L X+1 ", "F MAX ", "LBL 1 ", "IF ", "#1:=1; ", "IF #1=1 THEN ", "1 :", "<", ";", "ELSE ", "X1 #1;",
         "REPEAT ", "CASE 1 OF ", 'MSG("', "ALARM(", "G200 ", "G67 ", "M99 "]
# Codes for which the machine has a row: one that sets, one that does nothing, a family that is refused.
ROWS = """<MachineCodes xmlns="urn:isogloss:dialect:1">
  <Code name="G131" does="set" fields="Dwell.Time={P}"/><Code name="G132" does="nothing"/>
  <Code name="G9*" does="refused" text="not on this machine"/>
</MachineCodes>
"""
WORDS_WITH_ROWS = ["G131 P1 ", "G132 ", "G931 P1 ", "G131 (", "G132 [", "G132 / "]
DIALECTS = {"fanuc": "%\n", "haas": "%\n", "okuma": "%\n", "syntec": "%@MACRO\n", "siemens": "", "heidenhain": ""}


def seconds_of(isogloss, folder, dialect, text, limit, *arguments):
    (folder / "part.nc").write_text(text)
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    run = subprocess.run([isogloss, "run", "part.nc", "-d", dialect, "--emit", "none", *arguments], cwd=folder, capture_output=True,
                         check=False, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit)))
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before, run.returncode


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--seconds", type=int, default=8)
    options = parser.parse_args()
    failed, longest = 0, (0.0, "")
    lines = [(dialect, words, []) for dialect in DIALECTS for words in WORDS]
    lines += [("fanuc", words, ["--machine", "rows.xml"]) for words in WORDS_WITH_ROWS]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "rows.xml").write_text(ROWS)
        for dialect, words, arguments in lines:
            text = DIALECTS[dialect] + words * (BYTES // len(words)) + "\nM30\n"
            took, status = seconds_of(options.isogloss.resolve(), folder, dialect, text, options.seconds, *arguments)
            longest = max(longest, (took, f"{words!r} in {dialect}"))
            if status not in (0, 1):
                failed += 1
                print(f"{words!r} over and over in {dialect}: exit status {status} after {took:.1f} s")
    print(f"{len(lines)} lines, the longest time {longest[0]:.2f} s: {longest[1]}; {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
