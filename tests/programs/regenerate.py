#!/usr/bin/env python3
"""Golden programs: DIALECT/NAME.nc or DIALECT/ROOM/NAME.nc gives NAME.motions.csv and, on stderr, NAME.diagnostics.txt.

  regenerate.py --isogloss PATH [--check] [--once] [DIALECT/ROOM/NAME...]

Rewrites the expectations, or with --check compares them and shows what changed. NAME.args beside a program holds more
arguments. The checked host runs them: a syntax that breaks the contract shows among the diagnostics. Each program runs
once more with --call-all, unless --once is given, which must give the same motions and diagnostics: this proves what
wakes a syntax. Read an expectation against the control's manual before you commit it.
"""
import argparse
import difflib
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from golden_programs import arguments_of, dialect_of, golden_files  # noqa: E402: it lies in another folder

HERE = pathlib.Path(__file__).resolve().parent


def command_of(isogloss, program, *more):
    """The command that the expectations are of; it runs in the program's folder."""
    return [isogloss, "run", program.name, "-d", dialect_of(program), "--checked", "--emit", "motions", "--format", "csv",
            *more, *arguments_of(program)]


def results(isogloss, program, *more):
    """{expectation file: text} of one run."""
    run = subprocess.run(command_of(isogloss, program, *more), cwd=program.parent, capture_output=True, text=True,
                         timeout=60, check=False)
    if run.returncode not in (0, 1):
        raise RuntimeError(f"exit status {run.returncode}\n{run.stderr}")
    said = [line for line in run.stderr.splitlines(True) if ".xml:" not in line]  # the dialect has tests of its own
    return {program.with_suffix(".motions.csv"): run.stdout,
            program.with_suffix(".diagnostics.txt"): "".join(said) + f"exit status {run.returncode}\n"}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--once", action="store_true")
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    isogloss = options.isogloss.resolve()
    programs = [(HERE / n).with_suffix(".nc") for n in options.names] or golden_files(".nc")

    changed = 0
    for program in programs:
        title = program.relative_to(HERE).with_suffix("")
        try:
            texts = results(isogloss, program)
            with_all = texts if options.once else results(isogloss, program, "--call-all")
        except (RuntimeError, subprocess.TimeoutExpired) as error:
            changed += 1
            print(f"{title}: {error}")
            continue
        for path, text in texts.items():
            if with_all[path] != text:
                changed += 1
                sys.stdout.writelines(difflib.unified_diff(text.splitlines(True), with_all[path].splitlines(True),
                                                           path.name, f"{path.name} (--call-all)", n=1))
            old = path.read_text() if path.exists() else ""
            if text == old:
                continue
            changed += 1
            if options.check:
                sys.stdout.writelines(difflib.unified_diff(old.splitlines(True), text.splitlines(True),
                                                           f"{path.name} (expected)", f"{path.name} (now)", n=1))
            else:
                path.write_text(text)
                print(f"wrote {path.relative_to(HERE)}")
    expected = {p.with_suffix("") for p in golden_files(".nc")}
    for path in golden_files(".motions.csv"):
        if path.with_suffix("").with_suffix("") not in expected:
            changed += 1
            print(f"{path.relative_to(HERE)} has no program")
    print(f"{len(programs)} programs, {changed} expectations {'differ' if options.check else 'written'}")
    if options.check and changed:
        print("where the new ones are right: ./dev regenerate, and read the difference")
    return 1 if options.check and changed else 0


if __name__ == "__main__":
    sys.exit(main())
