#!/usr/bin/env python3
"""Runs every program of a folder through `isogloss run`: exit status 0 or 1, no crash, no hang.

  run_corpus.py --isogloss PATH [--timeout SECONDS] [--verbose] [FOLDER]

FOLDER (or $ISOGLOSS_CORPUS) holds one folder a dialect; without it exit status 77. Prints how many blocks and motions
came out of each folder, and its diagnostics by code.
"""
import argparse
import collections
import os
import pathlib
import re
import subprocess
import sys
import time

SKIPPED = 77
# Folder -> the dialects that read it, the best first; the first that is installed is taken.
NEAREST = {
    "fanuc": ("fanuc",), "haas": ("haas", "fanuc"), "okuma": ("okuma", "fanuc"), "linuxcnc": ("linuxcnc", "iso"),
    "hobby": ("linuxcnc", "iso"), "siemens": ("siemens", "iso"), "heidenhain": ("heidenhain", "iso"),
    "syntec": ("syntec", "fanuc"),
}
NOT_PROGRAMS = {".md", ".tsv", ".xml", ".json", ".txt", ".pdf", ".png"}
DIAGNOSTIC = re.compile(r": (error|warning|note): .*\[([A-Z]+-?\d+)\]")


def dialects(isogloss):
    run = subprocess.run([isogloss, "list", "dialects"], capture_output=True, text=True, timeout=60, check=True)
    return {line.split()[0] for line in run.stdout.splitlines() if line.strip()}


def run(isogloss, path, dialect, timeout):
    """(status or what went wrong, events, diagnostics by code, seconds)"""
    begin = time.monotonic()
    try:
        done = subprocess.run([isogloss, "run", path, "-d", dialect, "--emit", "motions", "--format", "csv",
                               "--max-errors", "0"], capture_output=True, timeout=timeout, check=False)
    except subprocess.TimeoutExpired:
        return "timeout", 0, collections.Counter(), timeout
    codes = collections.Counter(f"{m[2]} {m[1]}" for m in DIAGNOSTIC.finditer(done.stderr.decode(errors="replace")))
    return done.returncode, done.stdout.count(b"\n") - 1, codes, time.monotonic() - begin


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--timeout", type=float, default=20)
    parser.add_argument("--verbose", action="store_true", help="a line for each file")
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=os.environ.get("ISOGLOSS_CORPUS"))
    options = parser.parse_args()
    if not options.folder or not pathlib.Path(options.folder).is_dir():
        print("no corpus: give a folder or set ISOGLOSS_CORPUS")
        return SKIPPED

    isogloss = options.isogloss.resolve()
    known = dialects(isogloss)
    bad = total = 0
    for folder in sorted(p for p in pathlib.Path(options.folder).iterdir() if p.is_dir()):
        dialect = next((d for d in NEAREST.get(folder.name, ("fanuc",)) if d in known), None)
        files = [p for p in sorted(folder.rglob("*")) if p.is_file() and
                 (p.suffix.lower() not in NOT_PROGRAMS or p.suffix == ".txt")]
        if dialect is None:
            print(f"{folder.name}: {len(files)} files, no dialect for them is installed")
            continue
        codes, statuses, events = collections.Counter(), collections.Counter(), 0
        for path in files:
            status, count, found, seconds = run(isogloss, path, dialect, options.timeout)
            codes.update(found)
            statuses[status] += 1
            events += max(count, 0)
            total += 1
            if status not in (0, 1):
                bad += 1
                print(f"{path.relative_to(options.folder)}: exit status {status}")
            if options.verbose:
                print(f"  {path.relative_to(options.folder)}: {status}, {count} events, {seconds:.2f} s, {dict(found)}")
        print(f"{folder.name} as {dialect}: {len(files)} files, clean {statuses[0]}, with errors {statuses[1]}, "
              f"{events} events")
        for code, number in codes.most_common():
            print(f"    {number:6} {code}")
    print(f"{total} files, {bad} failed")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
