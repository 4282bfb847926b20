#!/usr/bin/env python3
"""Runs whole and damaged programs in several ways that must agree.

  consistency.py --isogloss PATH [--cases 100] [--seed S] [--keep DIR] [--dialects fanuc,iso,…]

The same program from a file and from standard input, fast, --checked, --call-all and both, with the line ends LF, CRLF
and CR, as JSON Lines and as CSV: the same motions, the same diagnostics at the same places, the same exit status. Every
output parses, holds finite numbers only, and its status agrees with its diagnostics. Case number i of a seed is always
the same bytes.
"""
import argparse
import csv
import io
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import budgeted  # noqa: E402: it lies in another folder
from golden_programs import dialect_of, golden_files  # noqa: E402
from random_bytes import BUDGETS, SUFFIXES, mutated  # noqa: E402

TIMEOUT = 60
WORD = re.compile(rb"[A-Z]+ ?=? ?[-+]?[0-9.]+|[A-Z]{2,}")


def mutated_words(rnd, text):
    """Words lost, doubled, exchanged or given another value: what a typing error or a wrong post-processor makes."""
    for _ in range(rnd.randrange(1, 6)):
        words = list(WORD.finditer(text))
        if not words:
            return text
        one, other = rnd.choice(words), rnd.choice(words)
        what = rnd.randrange(5)
        new = {0: b"", 1: one[0] + b" " + one[0], 2: other[0],
               3: re.sub(rb"[-+]?[0-9.]+$", rnd.choice((b"0", b"-1", b"1.5", b"359.999", b"1e9", b"99999")), one[0]),
               4: rnd.choice(b"XYZABCIJKRFPQDHL".decode()).encode() + one[0].lstrip(b"ABCDEFGHIJKLMNOPQRSTUVWXYZ")}[what]
        text = text[:one.start()] + new + text[one.end():]
    return text


def case(seed, number, programs):
    """(its dialect, its bytes)"""
    rnd = random.Random(f"{seed}/{number}")
    dialect, text = rnd.choice(programs)
    how = rnd.random()
    if how < 0.7:
        text = mutated_words(rnd, text)
    elif how < 0.9:
        text = mutated(rnd, text)
    return dialect, text.replace(b"\r", b"").replace(b"\0", b"")


class Run:
    """One run and its parts; `faults` lists what is wrong with this run alone."""

    def __init__(self, isogloss, dialect, path, *arguments, given=None):
        command = [isogloss, "run", path, "-d", dialect, "--diagnostics", "json", "--repeats", "0", *BUDGETS, *arguments]
        done = subprocess.run(command, input=given, capture_output=True, timeout=TIMEOUT, check=False)
        self.faults = []
        self.status = done.returncode
        self.said, self.motions = [], []
        for line in done.stderr.decode(errors="replace").splitlines():
            try:
                one = json.loads(line)
            except ValueError:
                self.faults.append(f"standard error holds {line[:100]!r}")
                continue
            self.said.append((one["Code"], one["Severity"], one.get("Line", 0), one.get("Column", 0), one["Message"]))
        try:
            text = done.stdout.decode()
            if "csv" in arguments:
                self.motions = list(csv.DictReader(io.StringIO(text)))
            else:
                self.motions = [json.loads(line, parse_constant=self.refuse) for line in text.splitlines()]
        except ValueError as wrong:
            self.faults.append(f"the output does not parse: {wrong}")
        if re.search(rb"null|[^a-zA-Z](nan|inf)[^a-zA-Z]", done.stdout):
            self.faults.append("the output holds a number that is not finite")
        errors = any(severity == "error" for _, severity, *_ in self.said)
        if self.status not in (0, 1) or (self.status == 1) != errors:
            self.faults.append(f"status {self.status}, {'with' if errors else 'without'} errors")

    @staticmethod
    def refuse(name):
        raise ValueError(name)

    def moves(self, *left_out):
        return [{k: v for k, v in m.items() if k not in left_out} for m in self.motions]

    def codes(self):
        return [one[0] for one in self.said]


def points(run):
    """The event and the coordinates of each line, from either format."""
    out = []
    for m in run.motions:
        if "event" in m:
            out.append((m["event"], *(float(m[k]) if m[k] else None for k in ("px", "py", "pz", "mx", "my", "mz", "a", "b", "c"))))
        else:
            program, machine = m.get("ProgramXyz", {}), m.get("MachineCoordinate", {})
            out.append((m["Event"], *(program.get(k) for k in "XYZ"), *(machine.get(k) for k in "XYZABC")))
    return out


def difference(isogloss, dialect, folder, text):
    """What disagrees in the runs of this text, or None."""
    path = folder / "part.nc"
    path.write_bytes(text)
    first = Run(isogloss, dialect, path)
    runs = {"--checked": Run(isogloss, dialect, path, "--checked"),
            "--call-all": Run(isogloss, dialect, path, "--call-all"),
            "--checked --call-all": Run(isogloss, dialect, path, "--checked", "--call-all"),
            "standard input": Run(isogloss, dialect, "-", given=text)}
    path.write_bytes(text.replace(b"\n", b"\r\n"))
    runs["CRLF"] = Run(isogloss, dialect, path)
    path.write_bytes(text.replace(b"\n", b"\r"))
    with_cr = Run(isogloss, dialect, path)
    path.write_bytes(text)
    as_csv = Run(isogloss, dialect, path, "--format", "csv")
    for name, run in {"the first run": first, "CR": with_cr, "CSV": as_csv, **runs}.items():
        if run.faults:
            return f"{name}: {run.faults[0]}"
    for name, run in runs.items():
        if run.status != first.status:
            return f"{name}: status {run.status}, not {first.status}"
        if run.moves("File") != first.moves("File"):
            return f"{name}: other motions"
        # What is looked for beside the program has no place beside standard input.
        words = (lambda one: one[:4]) if name == "standard input" else (lambda one: one)
        if [words(d) for d in run.said] != [words(d) for d in first.said]:
            return f"{name}: {sorted(set(map(words, run.said)) ^ set(map(words, first.said)))[:2]}"
    if with_cr.codes() != first.codes() or with_cr.moves("File", "Line") != first.moves("File", "Line"):
        return f"CR: {[(a, b) for a, b in zip(with_cr.codes(), first.codes()) if a != b][:1]} or other motions"
    if as_csv.codes() != first.codes() or points(as_csv) != points(first):
        return f"CSV: {[(a, b) for a, b in zip(points(as_csv), points(first)) if a != b][:1]}"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--cases", type=int, default=budgeted(100))
    parser.add_argument("--seed", default="1")
    parser.add_argument("--dialects", default="")
    parser.add_argument("--keep", type=pathlib.Path, help="write programs that disagree there")
    options = parser.parse_args()
    isogloss = options.isogloss.resolve()
    wanted = options.dialects.split(",") if options.dialects else None
    programs = [(dialect_of(p), p.read_bytes()) for p in golden_files()
                if p.suffix in SUFFIXES and (wanted is None or dialect_of(p) in wanted)]
    failures = 0
    with tempfile.TemporaryDirectory(prefix="isogloss-consistency-") as name:
        for number in range(options.cases):
            dialect, text = case(options.seed, number, programs)
            try:
                what = difference(isogloss, dialect, pathlib.Path(name), text)
            except subprocess.TimeoutExpired:
                what = f"no end after {TIMEOUT} s"
            if not what:
                continue
            failures += 1
            print(f"seed {options.seed} case {number} as {dialect}: {what}")
            if options.keep:
                options.keep.mkdir(parents=True, exist_ok=True)
                (options.keep / f"{options.seed}-{number}.{dialect}").write_bytes(text)
            if failures == 20:
                break
    print(f"{options.cases} cases, {failures} disagree")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
