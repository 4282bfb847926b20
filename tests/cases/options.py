#!/usr/bin/env python3
"""Every option of every syntax and dependency changes something in some case or program of the tests.

  options.py --isogloss PATH --source DIR [--list]

A case that gives an option must fail without it: its page is run again with the option removed. Where no case gives it,
a dialect does, and one of the dialect's programs must give another result without it, or with another value. The last
takes minutes: such options stand in options_elsewhere.txt and are checked by --full.
"""
import argparse
import collections
import functools
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import budgeted  # noqa: E402: it lies in another folder
from golden_programs import golden_files  # noqa: E402

DIALECTS = ("fanuc", "haas", "siemens", "heidenhain", "syntec", "iso")
HERE = pathlib.Path(__file__).resolve().parent


def elsewhere():
    """Options that no case and no dialect tests: "programs" do."""
    out = {}
    for line in (HERE / "options_elsewhere.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            part, option, how = line.split()
            out[part, option] = how
    return out


def run(isogloss, *arguments, status=None):
    done = subprocess.run([isogloss, *arguments], capture_output=True, text=True, timeout=60, check=False)
    if status is not None and done.returncode != status:
        sys.exit(f"{arguments}: status {done.returncode}\n{done.stderr}")
    return done


def snake(name):
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--isogloss", required=True, type=pathlib.Path)
    parser.add_argument("--source", required=True, type=pathlib.Path)
    parser.add_argument("--full", action="store_true", default=budgeted(1) > 1,
                        help="those that programs hold to account, too")
    options = parser.parse_args()
    isogloss = options.isogloss.resolve()
    known = elsewhere()
    pages = collections.defaultdict(list)  # a part may be configured on the page of another one
    for page in sorted(options.source.glob("plugins/**/*.md")):
        for part in set(re.findall(r"<([A-Z]\w+)[\s/>]", page.read_text())):
            pages[part].append(page)
    number, unheld = 0, []
    with tempfile.TemporaryDirectory(prefix="isogloss-options-") as folder:
        programs = Programs(isogloss, options.source, pathlib.Path(folder))
        for kind in ("syntaxes", "dependencies"):
            for part in json.loads(run(isogloss, "list", kind, "--json", status=0).stdout):
                declared = json.loads(run(isogloss, "inspect", part["Id"], "--json", status=0).stdout)
                for option in declared["Options"]:
                    number += 1
                    key = (part["Id"], option["Name"])
                    if known.get(key) == "programs" and not options.full:
                        continue
                    if any(is_held(isogloss, page, *key, pathlib.Path(folder)) for page in pages[part["Id"]]):
                        continue
                    if programs.notice_the_loss(*key):
                        continue
                    if key not in known or not programs.notice(kind, part["Id"], option):
                        unheld.append(key)
    for part, option in unheld:
        print(f"{part} {option}: nothing changes when it is taken away; give it a case")
    print(f"{number} options, {len(unheld)} held by nothing")
    return 1 if unheld else 0


class Programs:
    """The programs of the tests, run with two forms of their dialect."""

    def __init__(self, isogloss, source, folder):
        self.isogloss, self.source, self.folder = isogloss, source, folder
        self.outcomes = {}  # of each program in its dialect as it is

    def outcome(self, program, dialect, dialects):
        """Status, motions and diagnostics."""
        arguments = program.with_suffix(".args")
        more = arguments.read_text().split() if arguments.exists() else []
        done = subprocess.run([self.isogloss, "run", program.name, "-d", dialect, "--dialects", dialects.resolve(),
                               "--format", "csv", *more], capture_output=True, timeout=60, check=False, cwd=program.parent)
        return done.returncode, done.stdout, done.stderr

    def outcome_as_it_is(self, program, dialect):
        key = program, dialect
        if key not in self.outcomes:
            self.outcomes[key] = self.outcome(program, dialect, self.source / "dialects")
        return self.outcomes[key]

    def differ(self, name, dialects, one, other):
        """Does a program of the dialect give another result in its other form?"""
        for program in golden_files(".nc", name):
            if program.stat().st_size > 6000:
                continue
            before, after = self.outcome_as_it_is(program, one), self.outcome(program, other, dialects)
            if after[0] == 2:
                return False  # no such form
            if before[1:] != after[1:]:
                return True
        return False

    def notice_the_loss(self, part, option):
        """The dialect without the option, where a dialect gives it."""
        given = re.compile(rf'(<{part}\b[^<>]*?|<Configure (?:syntax|dependency)="{part}"[^<>]*?)'
                           rf'\s{re.escape(option)}="[^"]*"')
        for dialect in sorted((self.source / "dialects").glob("*.xml")):
            without, count = given.subn(r"\1", dialect.read_text())
            if count == 0:
                continue
            copy = self.folder / "dialects"
            shutil.rmtree(copy, ignore_errors=True)
            shutil.copytree(self.source / "dialects", copy)
            (copy / dialect.name).write_text(without)
            name = dialect.stem.split(".")[0]
            if self.differ(name, copy, name, name):
                return True
        return False

    def notice(self, kind, part, option):
        """The dialect with another value, in any dialect that has the part."""
        section, what = ("Chain", "syntax") if kind == "syntaxes" else ("Dependencies", "dependency")
        for name in DIALECTS:
            for value in others(option):
                form = self.folder / f"{name}_otherwise.xml"
                form.write_text(f'<Dialect xmlns="urn:isogloss:dialect:1" name="{form.stem}" extends="{name}"><{section}>'
                                f'<Configure {what}="{part}" {option["Name"]}="{value}"/></{section}></Dialect>')
                if run(self.isogloss, "lint", form).returncode == 0 and \
                        self.differ(name, self.source / "dialects", name, str(form)):
                    return True
        return False


def others(option):
    """Values that are not its default."""
    default, kind = option.get("Default"), option["Type"]
    if kind == "boolean":
        return ["false" if default == "true" else "true"]
    if kind == "choice":
        return [c for c in option["Choices"].split("|") if c != default]
    if kind in ("number", "integer"):
        value = float(default or 0)
        low, high = float(option.get("Minimum") or 0), float(option.get("Maximum") or 1e9)
        return [f"{v:g}" for v in dict.fromkeys((min(value * 2 + 1, high), max(low, value / 2 - 1), 1.0)) if v != value]
    return ["Parsing.Flags.G999" if "codes" in option["Name"] else ""]


def is_held(isogloss, page, part, option, folder):
    """Does a case of the page fail without the option?"""
    text = page.read_text()
    given = re.compile(rf'(<{part}\b[^<>]*?)\s{re.escape(option)}="[^"]*"')
    without, count = given.subn(r"\1", text)
    if count == 0:
        return False
    # Held, unless the page fails for another reason.
    return not holds(isogloss, without, folder) and holds(isogloss, text, folder)


@functools.cache
def holds(isogloss, text, folder):
    """Do all cases of this page hold?"""
    page = folder / "changed.md"
    page.write_text(text)
    return run(isogloss, "case", page).returncode == 0


if __name__ == "__main__":
    sys.exit(main())
