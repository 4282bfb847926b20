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
DIALECTS = {"fanuc": "%\n", "haas": "%\n", "okuma": "%\n", "syntec": "%@MACRO\n", "siemens": "", "heidenhain": ""}


def seconds_of(isogloss, folder, dialect, text, limit):
    (folder / "part.nc").write_text(text)
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    run = subprocess.run([isogloss, "run", "part.nc", "-d", dialect, "--emit", "none"], cwd=folder, capture_output=True,
                         check=False, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit)))
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before, run.returncode


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--seconds", type=int, default=8)
    options = parser.parse_args()
    failed, longest = 0, (0.0, "")
    with tempfile.TemporaryDirectory() as name:
        for dialect, head in DIALECTS.items():
            for words in WORDS:
                text = head + words * (BYTES // len(words)) + "\nM30\n"
                took, status = seconds_of(options.isogloss.resolve(), pathlib.Path(name), dialect, text, options.seconds)
                longest = max(longest, (took, f"{words!r} in {dialect}"))
                if status not in (0, 1):
                    failed += 1
                    print(f"{words!r} over and over in {dialect}: exit status {status} after {took:.1f} s")
    print(f"{len(WORDS) * len(DIALECTS)} lines, the longest time {longest[0]:.2f} s: {longest[1]}; {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
