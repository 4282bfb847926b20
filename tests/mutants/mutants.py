#!/usr/bin/env python3
"""Mutants of our own code: does a test fail where a place of a cycle, frame or five-axis syntax is wrong?

  mutants.py --release BUILD [--folder FOLDER] [--sample N] [--seed S] [--again] [--file PART]
             [--without-models] [--number N] [--jobs N]

Every mutant is compiled into one copy of the plugins, and the environment chooses one for each run (README.md). The
sample is drawn evenly over the files. FOLDER/report.md lists what lives; answered.md says why some cannot be told apart.
"""
import argparse
import collections
import concurrent.futures
import json
import pathlib
import random
import re
import sys
import threading
import time

from find_mutants import one_line
from instrument import Instrumented
from kill import Tests

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parents[1]
least_share = 0.9


def say(text):
    print(f"{time.strftime('%H:%M:%S')} {text}", flush=True)


# What identifies a mutant beyond the next edit: its file, the line of code, and the change.

def shown(text):
    return one_line(text.encode("latin-1").decode())


def identity(instrumented, mutant):
    text = instrumented.text(mutant.file)
    begin = text.rfind("\n", 0, mutant.start) + 1
    end = text.find("\n", mutant.start)
    return mutant.file, shown(text[begin:end]), change(instrumented, mutant)


def change(instrumented, mutant):
    before, _, after = mutant.change(instrumented.text(mutant.file)).partition(" → ")
    return f"{shown(before)} → {shown(after)}"


def line_of(instrumented, mutant):
    return instrumented.text(mutant.file).count("\n", 0, mutant.start) + 1


def row(cells):
    return "| " + " | ".join("`" + cell.replace("|", "\\|") + "`" for cell in cells) + " |"


def read_answers(text):
    """{identity: reason} of the rows of answered.md."""
    found = {}
    for line in text.splitlines():
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if len(cells) != 4 or not cells[0].startswith("`"):
            continue
        found[tuple(cell.strip("`").replace("\\|", "|") for cell in cells[:3])] = cells[3]
    return found


def sample(instrumented, count, seed, part):
    """The numbers of `count` mutants: one of each file in turn, until there are enough."""
    by_file = collections.defaultdict(list)
    for number, mutant in enumerate(instrumented.mutants, 1):
        if number not in instrumented.refused and part in mutant.file:
            by_file[mutant.file].append(number)
    for name, numbers in by_file.items():
        random.Random(f"{seed} {name}").shuffle(numbers)
    names = sorted(by_file)
    random.Random(seed).shuffle(names)
    drawn, depth = [], 0
    while len(drawn) < count and any(len(by_file[name]) > depth for name in names):
        drawn += [by_file[name][depth] for name in names if len(by_file[name]) > depth]
        depth += 1
    return sorted(drawn[:count])


def run(instrumented, tests, numbers, jobs, results, results_file):
    lock = threading.Lock()
    begin = time.monotonic()

    def one(number):
        mutant = instrumented.mutants[number - 1]
        killer = tests.killer(number, mutant)
        with lock:
            results["|".join(identity(instrumented, mutant))] = killer
            done = results["done"] = results.get("done", 0) + 1
            if done % 25 == 0 or done == len(numbers):
                say(f"{done} of {len(numbers)} mutants, {(time.monotonic() - begin) / done:.1f} s for each")
                results_file.write_text(json.dumps(results))
        return number, killer

    results["done"] = 0
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        return dict(pool.map(one, numbers))


def report(instrumented, numbers, killers, answered, seed):
    """The text of report.md; the share that was killed; the mutants that live without an answer."""
    alive = [n for n in numbers if n not in killers or not killers[n]]
    lives = [n for n in alive if identity(instrumented, instrumented.mutants[n - 1]) not in answered]
    killed = len(numbers) - len(alive)
    compiled = len(instrumented.mutants) - len(instrumented.refused)
    lines = ["# Mutants", "",
             f"{compiled} mutants of {len(instrumented.files)} files; a sample of {len(numbers)}, seed {seed}: {killed} killed "
             f"({share(killed, len(numbers))}), {len(alive) - len(lives)} answered, {len(lives)} alive.", "",
             "Left out: " + ", ".join(f"{count} in {reason}" for reason, count in sorted(instrumented.left_out.items())) +
             f", {len(instrumented.refused)} that the compiler refuses.", ""]
    for title, key in (("operator", lambda m: m.operator), ("file", lambda m: m.file)):
        lines += [f"| {title} | mutants | killed | answered | alive |", "|---|---|---|---|---|"]
        groups = collections.defaultdict(list)
        for number in numbers:
            groups[key(instrumented.mutants[number - 1])].append(number)
        for name, own in sorted(groups.items()):
            left = sum(n in lives for n in own)
            dead = sum(n not in alive for n in own)
            lines.append(f"| {name} | {len(own)} | {dead} | {len(own) - dead - left} | {left} |")
        lines.append("")
    lines += ["## Alive", ""]
    for number in lives:
        mutant = instrumented.mutants[number - 1]
        unreached = number in killers and killers[number] is None
        lines += [f"* {mutant.file}:{line_of(instrumented, mutant)}, {mutant.operator}, number {number}" +
                  (", **reached by no test**" if unreached else ""),
                  "", "  " + row(identity(instrumented, mutant)), ""]
    return "\n".join(lines) + "\n", killed / max(len(numbers), 1), lives


def share(part, whole):
    return f"{100 * part / max(whole, 1):.1f} %"


def stale_answers(instrumented, answered):
    files = {name for name, _, _ in answered}
    known = {identity(instrumented, m) for m in instrumented.mutants if m.file in files}
    return [a for a in answered if a not in known]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--release", required=True, type=pathlib.Path, help="the release build: its command and its units")
    parser.add_argument("--folder", type=pathlib.Path, default=SOURCE / "build-mutants")
    parser.add_argument("--sample", type=int, default=500)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--file", default="", help="only files whose path contains this")
    parser.add_argument("--again", action="store_true", help="of the sample, only those that lived the last time")
    parser.add_argument("--without-models", action="store_true", help="leave the models out, which take most of the time")
    parser.add_argument("--number", type=int, action="append", help="only this mutant, with what its test says")
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)

    instrumented = Instrumented(SOURCE, options.release.resolve(), options.folder.resolve(), say)
    say("finding the mutants")
    instrumented.find()
    say(f"{len(instrumented.mutants)} mutants of {len(instrumented.files)} files; building")
    instrumented.build(options.jobs)
    tests = Tests(SOURCE, instrumented, *([()] if options.without_models else []))
    tests.baseline(options.jobs, say)
    answered = read_answers((HERE / "answered.md").read_text())
    stale = stale_answers(instrumented, answered)

    if options.number:
        for number in options.number:
            mutant = instrumented.mutants[number - 1]
            print(f"{mutant.file}:{line_of(instrumented, mutant)}: {change(instrumented, mutant)}: "
                  f"{tests.killer(number, mutant) or 'alive'}\n{tests.output.decode(errors='replace')}")
        return 0

    numbers = sample(instrumented, options.sample, options.seed, options.file)
    results_file = options.folder / "results.json"
    results = json.loads(results_file.read_text()) if results_file.exists() else {}
    waiting = [n for n in numbers if identity(instrumented, instrumented.mutants[n - 1]) not in answered]
    last = {n: results.get("|".join(identity(instrumented, instrumented.mutants[n - 1]))) for n in waiting}
    killers = {n: killer for n, killer in last.items() if options.again and killer}
    killers |= run(instrumented, tests, [n for n in waiting if n not in killers], options.jobs, results, results_file)
    results_file.write_text(json.dumps(results))
    text, killed, lives = report(instrumented, numbers, killers, answered, options.seed)
    (options.folder / "report.md").write_text(text)
    print("\n".join(text.splitlines()[2:5]))
    for answer in stale:
        print(f"answered.md: no mutant is this one any more: {answer[0]}: {answer[2]}")
    if lives:
        print(f"{len(lives)} live without an answer: {options.folder / 'report.md'}")
    if killed < least_share:
        print(f"fewer than {100 * least_share:.0f} % are killed")
    return 1 if stale or killed < least_share else 0


if __name__ == "__main__":
    sys.exit(main())
