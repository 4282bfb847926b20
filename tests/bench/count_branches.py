#!/usr/bin/env python3
"""Runs programs through a build with ISOGLOSS_PROFILE=count, so that it notes how often each branch is taken.

  count_branches.py --isogloss FILE --workload FILE

The workloads in three languages and two formats, and the golden programs of all dialects, each once.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile

import surface_forms

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))

from golden_programs import arguments_of, dialect_of, golden_files  # noqa: E402: it lies in another folder

BLOCKS = 20_000
SEED = 11  # other programs than those that are measured
FORMATS = (["--emit", "none"], ["--emit", "motions", "--format", "csv"], ["--emit", "motions", "--format", "jsonl"])


def run(isogloss, program, dialect, *more):
    done = subprocess.run([isogloss, "run", program.name, "-d", dialect, *more], cwd=program.parent, check=False,
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode not in (0, 1):
        sys.exit(f"{program}: exit status {done.returncode}\n{done.stderr}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("--workload", required=True, type=lambda path: pathlib.Path(path).resolve())
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        programs = []
        for kind in ("surface", "mixed", "drilling", "five-axis"):
            program = folder / f"{kind}.nc"
            subprocess.run([options.workload, kind, str(BLOCKS), "--seed", str(SEED), "-o", program], check=True)
            machine = ["--machine", HERE / "five_axis.xml"] if kind == "five-axis" else []
            programs += [(program, dialect, machine) for dialect in (["fanuc"] if machine else ["fanuc", "iso"])]
        text = (folder / "surface.nc").read_text()
        for dialect, suffix, form in (("siemens", "mpf", surface_forms.siemens),
                                      ("heidenhain", "h", surface_forms.klartext)):
            program = folder / f"surface.{suffix}"
            program.write_text(form(text))
            programs.append((program, dialect, []))
        for program, dialect, more in programs:
            for form in FORMATS:
                run(options.isogloss, program, dialect, *more, *form)
        for program in golden_files(".nc"):
            run(options.isogloss, program, dialect_of(program), *FORMATS[1], *arguments_of(program))


if __name__ == "__main__":
    main()
