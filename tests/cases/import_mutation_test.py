#!/usr/bin/env python3
"""Importers and files that are cut, shuffled or damaged: a report, never a crash, a broken contract or a bad table.

  import_mutation_test.py --isogloss PATH --source DIR [--files N] [--every N] [--seed S] [--keep DIR]

The files are those of the importers' cases. Each is damaged in N ways. `isogloss import` must end with status 0 or 1 and
report no fault of the importer (IG-0127); the tables that it writes must be well-formed XML, and a dialect of the brand
must accept each row (no IG-0219, IG-0220 and IG-0432).
"""
import argparse
import collections
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import budgeted  # noqa: E402: it lies in another folder

FILE = re.compile(r"^#File: *(?P<name>\S.*?)\s*\n\s*```[a-z]*\n(?P<text>.*?)^```", re.MULTILINE | re.DOTALL)
FAULTS = ("[IG-0127]", "[IG-0219]", "[IG-0220]", "[IG-0432]")
ODD = ["0", "-1", "1e9", "99999999999999999999", "5.123", "\t", "\"", "'", "%", ";", "=", "(", "[", "\x7f", "\u00e4", "NaN", ""]


def cases(source, importers):
    """The files of each importer's cases, by its id."""
    found = collections.defaultdict(list)
    for page in sorted(source.glob("plugins/**/*.md")):
        text = page.read_text()
        title = text.split("\n", 1)[0].removeprefix("# ").strip()
        if title in importers:
            found[title] += [(m["name"], m["text"]) for m in FILE.finditer(text)]
    return found


def damaged(rnd, text):
    for _ in range(rnd.randint(1, 4)):
        lines = text.split("\n")
        kind = rnd.randrange(7)
        at = rnd.randrange(len(text) + 1)
        if kind == 0:
            text = text[:at]
        elif kind == 1:
            rnd.shuffle(lines)
            text = "\n".join(lines)
        elif kind == 2:
            lines.insert(rnd.randrange(len(lines) + 1), rnd.choice(lines))
            text = "\n".join(lines)
        elif kind == 3:
            text = text[:at] + rnd.choice(ODD) + text[at + rnd.randint(0, 3):]
        elif kind == 4:
            numbers = list(re.finditer(r"\d+", text))
            if numbers:
                m = rnd.choice(numbers)
                text = text[:m.start()] + rnd.choice(ODD) + text[m.end():]
        elif kind == 5:
            text = text.replace("\n", rnd.choice(["\r\n", "\r", "\n\n", " "]))
        else:
            text = text[:at] + text[at + rnd.randint(1, 20):]
    return text


def run(*command, **options):
    return subprocess.run(command, capture_output=True, text=True, timeout=120, check=False, **options)


def machine_of(importer):
    dialect = next((brand.lower() for brand in ("Siemens", "Heidenhain", "Haas") if importer.startswith(brand)), "fanuc")
    return (f'<Machine xmlns="urn:isogloss:dialect:1" name="m" dialect="{dialect}"><Include src="tables.xml"/></Machine>')


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--source", required=True, type=pathlib.Path)
    parser.add_argument("--files", type=int, default=budgeted(6), help="damaged ones of each file")
    parser.add_argument("--every", type=int, default=1, help="of the files only each Nth")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--keep", type=pathlib.Path, help="write files that show a fault there")
    options = parser.parse_args()
    isogloss = options.isogloss.resolve()
    importers = [i["Id"] for i in json.loads(run(isogloss, "list", "importers", "--json").stdout)]
    rnd = random.Random(options.seed)
    tried = faults = 0
    for importer, files in cases(options.source, importers).items():
        for name, text in files[::options.every]:
            for _ in range(options.files):
                bad = damaged(rnd, text).encode(rnd.choice(["utf-8", "utf-8", "latin-1", "utf-16"]), "replace")
                with tempfile.TemporaryDirectory(prefix="isogloss-import-") as folder:
                    path = pathlib.Path(folder)
                    (path / pathlib.Path(name).name).write_bytes(bad)
                    done = run(isogloss, "import", pathlib.Path(name).name, "--format", importer, "-o", "tables.xml",
                               cwd=path)
                    tried += 1
                    report = done.stderr
                    wrong = done.returncode not in (0, 1)
                    if done.returncode == 0:
                        xml.etree.ElementTree.parse(path / "tables.xml")
                        (path / "machine.xml").write_text(machine_of(importer))
                        report += run(isogloss, "lint", "-m", "machine.xml", "--repeats", "0", cwd=path).stderr
                    if wrong or any(fault in report for fault in FAULTS):
                        faults += 1
                        lines = [line for line in report.splitlines() if any(f in line for f in FAULTS)] or [report]
                        print(f"{importer}, {name}: status {done.returncode}: {lines[0][:300]}")
                        if options.keep:
                            options.keep.mkdir(parents=True, exist_ok=True)
                            (options.keep / f"{faults}.{pathlib.Path(name).name}").write_bytes(bad)
    print(f"{tried} damaged files, {faults} faults")
    return 1 if faults or tried == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
