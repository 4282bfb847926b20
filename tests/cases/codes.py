#!/usr/bin/env python3
"""Every code of a diagnostic is provoked by a test, raised by some source, and declared once.

A test that provokes a code names it: the diagnostics of a page's case, an expectation of a golden program, a unit test
or a test script. Those are executed elsewhere; this test only checks that each code stands in one of them.
"""
import argparse
import collections
import json
import pathlib
import re
import subprocess
import sys

CODE = re.compile(r"\b[A-Z]{2,4}-\d{4}\b")
EXPECTED = re.compile(r"#Diagnostics:\s*```[a-z]*\n(.*?)```", re.S)


def codes_of_pages(source):
    for page in source.glob("plugins/**/*.md"):
        for block in EXPECTED.findall(page.read_text()):
            yield from CODE.findall(block)


def codes_of_tests(source):
    here = pathlib.Path(__file__).resolve()
    for pattern in ("host/**/*_test.cpp", "plugins/**/*_test.cpp", "tests/**/*.py", "tests/**/*.cpp", "host/python/tests/*.py",
                    "tests/programs/**/*.diagnostics.txt", "tests/macro/programs.txt"):
        for file in source.glob(pattern):
            if file.resolve() != here:
                # What must not be said provokes nothing.
                lines = [line for line in file.read_text(errors="replace").splitlines() if "NotIn" not in line]
                yield from CODE.findall("\n".join(lines))


def codes_in_sources(source):
    """Where each code is declared, and where it is raised: the declaration has a severity before it."""
    declared, raised = collections.Counter(), set()
    for pattern in ("host/**/*.[ch]pp", "plugins/**/*.[ch]pp"):
        for file in source.glob(pattern):
            if file.name.endswith("_test.cpp"):
                continue
            text = re.sub(r"//.*", "", file.read_text())
            for match in re.finditer(r'"([A-Z]{2,4}-\d{4})"', text):
                before = text[max(0, match.start() - 60):match.start()].rstrip().rstrip(",").rstrip()
                if re.search(r"(?<!::)\b(IG_)?(error|warning|note|ERROR|WARNING|NOTE)$", before):
                    declared[match[1]] += 1
                else:
                    raised.add(match[1])
    return declared, raised


def codes_without_table(source, rows):
    """A plugin raises only codes of its own table, in which those of SDK headers stand that it includes."""
    tables = collections.defaultdict(set)
    for row in rows:
        for plugin in row["Plugin"].split(", "):
            tables[plugin].add(row["Code"])
    for file in sorted(source.glob("plugins/*/**/*.[ch]pp")):
        plugin = file.relative_to(source / "plugins").parts[0]
        if not file.name.endswith("_test.cpp"):
            for code in sorted(set(re.findall(r'diag\("([A-Z]{2,4}-\d{4})"\)', file.read_text())) - tables[plugin]):
                yield f"{file.relative_to(source)} raises {code}, which no file of plugin {plugin} declares"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--isogloss", required=True)
    parser.add_argument("--source", required=True, type=pathlib.Path)
    options = parser.parse_args()
    done = subprocess.run([options.isogloss, "list", "diagnostics", "--json"], capture_output=True, text=True, check=True)
    rows = json.loads(done.stdout)
    codes = [row["Code"] for row in rows]
    provoked = set(codes_of_pages(options.source)) | set(codes_of_tests(options.source))
    declared, raised = codes_in_sources(options.source)
    faults = [f"{code} is provoked by no test" for code in codes if code not in provoked]
    faults += [f"{row['Code']} has no {word.lower()}" for row in rows for word in ("Explanation", "Example") if not row[word]]
    faults += [f"{code} is declared {n} times" for code, n in declared.items() if n > 1]
    faults += [f"{code} is declared and raised by nothing" for code in codes if code not in raised]
    faults += [f"{code} is raised and not declared" for code in sorted(raised - set(codes))]
    faults += codes_without_table(options.source, rows)
    for fault in faults:
        print(fault)
    print(f"{len(codes)} codes, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
