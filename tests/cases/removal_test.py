#!/usr/bin/env python3
"""No syntax holds the order of two others together: a dialect without it still says which of them comes first.

  removal_test.py --isogloss PATH

Each syntax of each dialect is removed in turn, as somebody does who deletes its files. What else is missing then, such
as the writer of a field, is for the integrator to see; a new doubt about the order (IG-0241) is a fault here.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

DIALECT = """<?xml version="1.0" encoding="UTF-8"?>
<Dialect xmlns="urn:isogloss:dialect:1" name="without" title="Without one syntax" extends="{dialect}">
  <Chain><Remove syntax="{syntax}"/></Chain>
</Dialect>
"""


def run(*command, **options):
    return subprocess.run(command, capture_output=True, text=True, timeout=60, check=False, **options)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    isogloss = parser.parse_args().isogloss.resolve()
    removed = faults = 0
    with tempfile.TemporaryDirectory(prefix="isogloss-removal-") as name:
        folder = pathlib.Path(name)
        for dialect in [d["Name"] for d in json.loads(run(isogloss, "list", "dialects", "--json").stdout)]:
            chain = json.loads(run(isogloss, "inspect", dialect, "--json").stdout)["Chain"]
            for alias in [element["As"] for element in chain]:
                (folder / "without.xml").write_text(DIALECT.format(dialect=dialect, syntax=alias))
                done = run(isogloss, "lint", "without.xml", cwd=folder)
                removed += 1
                for line in done.stderr.splitlines():
                    if "[IG-0241]" in line or "[IG-0112]" in line:
                        faults += 1
                        print(f"{dialect} without {alias}: {line}")
    print(f"{removed} syntaxes removed, {faults} faults")
    return 1 if faults or removed == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
