#!/usr/bin/env python3
"""Does each source compile by itself, without a warning? A unity build hides an include that is missing.

  stands_alone.py BUILD [JOBS]    BUILD holds compile_commands.json of a configuration without unity
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor


CACHE = shutil.which("ccache") is not None and "CCACHE_DISABLE" not in os.environ


def check(entry):
    """With a compiler cache a source that has not changed is not read again; without one nothing is generated."""
    if not CACHE:
        return run(re.sub(r" -o \S+ -c ", " -fsyntax-only ", entry["command"]), entry["directory"])
    with tempfile.TemporaryDirectory(prefix="isogloss-alone-") as folder:
        command = re.sub(r" -o \S+ -c ", f" -O0 -g0 -o {folder}/alone.o -c ", entry["command"])
        return run("ccache " + command.removeprefix("ccache "), entry["directory"])


def run(command, directory):
    done = subprocess.run(command, shell=True, cwd=directory, capture_output=True, text=True, check=False)
    return done.returncode, done.stderr


def main():
    build = pathlib.Path(sys.argv[1])
    jobs = int(sys.argv[2]) if len(sys.argv) > 2 else os.cpu_count()
    entries = json.loads((build / "compile_commands.json").read_text())
    ours = [e for e in entries if not pathlib.Path(e["file"]).is_relative_to(build.resolve())
            and re.search(r"/(host|plugins)/.*\.cpp$", e["file"])]
    with ThreadPoolExecutor(jobs) as pool:
        results = list(pool.map(check, ours))
    for status, text in results:
        if status or text:
            print(text, file=sys.stderr)
    failed = sum(1 for status, text in results if status or text)
    print(f"{len(ours)} sources compiled alone, {failed} with faults")
    return 1 if failed or not ours else 0


if __name__ == "__main__":
    sys.exit(main())
