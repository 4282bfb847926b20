#!/usr/bin/env python3
"""A program as a binary stream and as numpy arrays, against a run without output: medians and minima of processor and wall time.

  /usr/bin/python3 arrays.py PROGRAM [--build DIR] [--dialect iso] [--runs N]

Commands run in turn, after one round to warm up. "arrays" is the whole interpreter; "in Python" is isogloss.run() alone,
measured inside it.
"""
import argparse
import json
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time

SCRIPT = """
import json, resource, sys, time, isogloss
def used(): return (lambda r: r.ru_utime + r.ru_stime)(resource.getrusage(resource.RUSAGE_SELF))
cpu, wall = used(), time.perf_counter()
result = isogloss.run(sys.argv[1], dialect=sys.argv[2], summary=sys.argv[3] == "summary")
print(json.dumps([used() - cpu, time.perf_counter() - wall, len(result)]))
"""


def measure(command, environment):
    """(processor time, wall time, output) of one process; `-o FILE` of the last one is removed by the caller."""
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    out = subprocess.run(command, env=environment, capture_output=True, check=True).stdout
    wall, after = time.perf_counter() - begin, resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, wall, out


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2] / "build")
    parser.add_argument("--dialect", default="iso")
    parser.add_argument("--runs", type=int, default=9)
    options = parser.parse_args()
    run = [str(options.build / "isogloss"), "run", options.program, "-d", options.dialect]
    python = [sys.executable, "-c", SCRIPT, options.program, options.dialect]
    environment = {**os.environ, "PYTHONPATH": str(options.build / "python")}
    with tempfile.TemporaryDirectory() as folder:
        commands = {
            "none": run + ["--emit", "none"],
            "csv to /dev/null": run + ["--format", "csv", "-o", "/dev/null"],
            "binary to /dev/null": run + ["--format", "binary", "-o", "/dev/null"],
            "binary to a file": run + ["--format", "binary", "-o", f"{folder}/part.igm"],
            "arrays": python + ["plain"],
            "arrays with summary": python + ["summary"],
        }
        cpu, wall = {}, {}
        for turn in range(options.runs + 1):
            for name, command in commands.items():
                used, passed, out = measure(command, environment)
                if turn == 0:
                    continue
                cpu.setdefault(name, []).append(used)
                wall.setdefault(name, []).append(passed)
                if name.startswith("arrays"):
                    inside = json.loads(out)
                    cpu.setdefault(name + ", in Python", []).append(inside[0])
                    wall.setdefault(name + ", in Python", []).append(inside[1])
    print("| command | cpu ms | of none | wall ms | of none | fastest: wall ms | of none |\n|" + "---|" * 7)
    for name in cpu:
        columns = [(statistics.median, cpu), (statistics.median, wall), (min, wall)]
        figures = [(of(times[name]), of(times["none"])) for of, times in columns]
        print(f"| {name} | " + " | ".join(f"{f * 1e3:.0f} | {f / none:.2f}" for f, none in figures) + " |")


if __name__ == "__main__":
    main()
