#!/usr/bin/env python3
"""Feeds random bytes and damaged programs to `isogloss run`: exit status 0, 1 or 2, never a signal, 3 or a hang.

  random_bytes.py --isogloss PATH [--cases 600] [--seed S] [--keep DIR] [--dialects fanuc,iso,haas,…]

Case number i of a seed is always the same bytes. Cases run in batches, a file each; a batch that fails is split
to find the file.
"""
import argparse
import pathlib
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import budgeted  # noqa: E402: it lies in another folder
from golden_programs import golden_files  # noqa: E402

SUFFIXES = {".nc", ".mpf", ".spf", ".h", ".i"}
TIMEOUT = 20
BATCH = 20
OUTPUTS = (["--emit", "motions", "--format", "csv"], ["--emit", "blocks", "--format", "jsonl"],
           ["--emit", "motions", "--format", "jsonl", "--zero-moves", "--exact"],
           ["--emit", "motions", "--format", "text"],
           ["--emit", "none", "--summary", "--block-skip", "1,2", "--optional-stop"])
# Endless loops are common among damaged macro programs; the budgets' own defaults have tests of their own.
BUDGETS = ["--max-loop-blocks", "20000", "--max-jumps", "20000"]
# What an interpreter is likely to stumble over, more than single bytes would find.
TOKENS = [b"G1", b"G02", b"G3", b"G28", b"G53", b"G52", b"G10", b"L2", b"G81", b"G82", b"G80", b"G91", b"G90", b"G43",
          b"G68.2", b"G65", b"M98", b"M99", b"M6", b"M30", b"GOTO", b"IF", b"WHILE", b"[", b"]", b"#", b"#1=", b"(",
          b")", b"%", b";", b"/", b"/9", b"O", b"N", b"X", b"Y", b"Z", b"I", b"J", b"R", b"K99999999", b"P0", b"F0",
          b"1e9", b"0x1F", b"-", b"+", b".", b"--1", b"1.2.3", b"99999999999999999999999", b".000000000000000000001",
          b"nan", b"inf", b"\n", b"\r\n", b"\r", b"\0", b"\t", b" ", b"\xef\xbb\xbf", b"\xff", b"\xc3\xa9", b"\x1a",
          b"Q1=", b"FN 0:Q1=", b"LBL 1\n", b"CALL LBL 1 REP3\n", b"CYCL DEF 200", b"CYCL CALL", b"L X+Q1", b"CC", b"C X+1 DR+",
          b"PLANE SPATIAL SPA+1", b"TOOL CALL 1 Z", b"~\n",
          b"<", b">", b"\"", b"'", b"\\", b"$", b"@", b"~", b"=", b"?", b"*", b"{", b"}",
          b"R1=", b"X=IC(1)", b"CYCLE83(50,0,2,-20)", b"IF R1>0", b"ENDIF", b"GOTOF A", b"A:", b"TRANS X1", b"MCALL", b"AP=30",
          b"%@MACRO", b"//", b"@1:=", b"@[", b"$2", b"G200.1 X1", b"G68.18", b"G54P7", b"M98H10", b"G70"]


def random_program(rnd):
    kind = rnd.randrange(3)
    if kind == 0:
        return rnd.randbytes(rnd.randrange(0, 2000))
    if kind == 1:
        return b"".join(rnd.choice(TOKENS) for _ in range(rnd.randrange(0, 400)))
    letters = b"GMXYZIJKRFSTHDPQLNO#()/%;[]=.-+0123456789 \n"
    return bytes(rnd.choice(letters) for _ in range(rnd.randrange(0, 2000)))


def mutated(rnd, text):
    text = bytearray(text)
    for _ in range(rnd.randrange(1, 12)):
        at = rnd.randrange(len(text) + 1)
        what = rnd.randrange(6)
        if what == 0:
            text[at:at + 1] = rnd.randbytes(1)
        elif what == 1:
            text[at:at] = rnd.choice(TOKENS)
        elif what == 2:
            del text[at:at + rnd.randrange(1, 30)]
        elif what == 3:
            other = rnd.randrange(len(text) + 1)
            text[at:at] = text[other:other + rnd.randrange(1, 200)]
        elif what == 4:
            text[at:at] = rnd.choice(b"XYZGRK0123456789.-".decode()).encode() * rnd.choice((2, 20, 2000, 70000))
        else:
            del text[at:]
    return bytes(text)


def case(seed, number, programs):
    rnd = random.Random(f"{seed}/{number}")
    return random_program(rnd) if rnd.random() < 0.4 else mutated(rnd, rnd.choice(programs))


def fault(isogloss, dialect, output, paths):
    """What went wrong in this run, or None."""
    command = [isogloss, "run", *paths, "-d", dialect, *output, *BUDGETS]
    try:
        run = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, timeout=TIMEOUT, check=False)
    except subprocess.TimeoutExpired:
        return f"no end after {TIMEOUT} s"
    if run.returncode in (0, 1, 2):
        return None
    return f"exit status {run.returncode}: {run.stderr[-400:].decode(errors='replace')}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--cases", type=int, default=budgeted(600))
    parser.add_argument("--seed", default="1")
    parser.add_argument("--dialects", default="fanuc,iso,haas,mazak,okuma,syntec,heidenhain,siemens")
    parser.add_argument("--keep", type=pathlib.Path, help="write cases that go wrong there")
    options = parser.parse_args()
    isogloss = options.isogloss.resolve()
    programs = [p.read_bytes() for p in golden_files() if p.suffix in SUFFIXES]
    number = failures = 0
    with tempfile.TemporaryDirectory(prefix="isogloss-random-") as name:
        folder = pathlib.Path(name)
        while number < options.cases and failures < 10:
            paths = []
            for _ in range(BATCH):
                path = folder / f"{number}.nc"
                path.write_bytes(case(options.seed, number, programs))
                paths.append(path)
                number += 1
            output = OUTPUTS[number // BATCH % len(OUTPUTS)]
            for dialect in options.dialects.split(","):
                if not fault(isogloss, dialect, output, paths):
                    continue
                alone = [(p, fault(isogloss, dialect, output, [p])) for p in paths]
                for path, what in [(p, w) for p, w in alone if w] or [(paths[0], "only together with its batch")]:
                    failures += 1
                    print(f"seed {options.seed} case {path.stem} as {dialect} {' '.join(output)}: {what}")
                    if options.keep:
                        options.keep.mkdir(parents=True, exist_ok=True)
                        (options.keep / f"{options.seed}-{path.name}").write_bytes(path.read_bytes())
            for path in paths:
                path.unlink()
    print(f"{number} cases, {failures} went wrong")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
