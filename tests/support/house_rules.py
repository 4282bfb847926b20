#!/usr/bin/env python3
"""Rules of the house that no compiler knows. Prints each breach as file:line: what; exits 1 when there is one."""
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
longest_page = 150
at_the_top = {".clang-format", ".clang-tidy", ".editorconfig", ".gitignore", "ARCHITECTURE.md", "CHANGELOG.md",
              "CMakeLists.txt", "CMakePresets.json", "CONTRIBUTING.md", "LICENSE", "README.md", "SECURITY.md", "dev"}


def files(*patterns):
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z", "--", *patterns], cwd=ROOT,
                            check=True, capture_output=True, text=True).stdout
    return [Path(name) for name in listed.split("\0") if name and (ROOT / name).is_file()]


def lines(path):
    return enumerate((ROOT / path).read_text(encoding="utf-8", errors="replace").splitlines(), 1)


def grep(paths, pattern, what):
    for path in paths:
        for number, line in lines(path):
            found = re.search(pattern, line)
            if found:
                yield f"{path}:{number}: {what}: {found.group(0)}"


def pages():
    """One syntax, one .cpp, one .md of the same name with at least one case."""
    for path in files("plugins/*/*_syntax.cpp"):
        if not (ROOT / path).with_suffix(".md").is_file():
            yield f"{path}:1: has no page {path.stem}.md"
    for path in files("plugins/*/*_syntax.md"):
        if not (ROOT / path).with_suffix(".cpp").is_file():
            yield f"{path}:1: is the page of no syntax"
        if "#AfterBuild:" not in (ROOT / path).read_text():
            yield f"{path}:1: has no case"
    for path in files("plugins/*.md"):
        others = path.name.endswith(".cases.md")
        count = sum(1 for _ in lines(path))
        if not others and count > longest_page:
            yield f"{path}:{count}: a page is read in two minutes: move cases that teach little to {path.stem}.cases.md"
        if others and not (ROOT / path.parent / path.name.replace(".cases.md", ".md")).is_file():
            yield f"{path}:1: holds the cases of no page"
    empty = re.compile(r"#Diagnostics:\s*```\w*\s*```")
    for path in files("plugins/*.md"):
        for found in empty.finditer((ROOT / path).read_text()):
            line = (ROOT / path).read_text()[:found.start()].count("\n") + 1
            yield f"{path}:{line}: a case without #Diagnostics: expects none"


def boundaries():
    """Arrows point one way: cli -> engine -> abi <- sdk <- plugins; the engine knows no G-code and no controller."""
    engine = [path for path in files("host/engine/*", "host/cli/*", "host/abi/*.h")
              if path.suffix in (".cpp", ".hpp", ".h") and not path.stem.endswith("_test")]
    yield from grep([path for path in engine if "engine" in path.parts], r'"[GM]\d{1,3}(\.\d)?"', "the engine names a code")
    yield from grep([path for path in engine if "engine" in path.parts], r"(?i)\b(fanuc|siemens|heidenhain|syntec)\b",
                    "the engine names a controller")
    yield from grep(engine, r'#include\s+[<"](isogloss/(sdk|block|fields|motion|plugin)\.hpp|plugins/)',
                    "the host includes what is for plugins")
    yield from grep(files("host/session/*.cpp", "host/session/*.hpp"),
                    r'#include\s+[<"](session|command_line|terminal|output_file|CLI/)', "what is shared includes the command's")
    yield from grep(files("host/sdk/*.hpp", "plugins/*.cpp", "plugins/*.hpp"),
                    r'#include\s+[<"](isogloss/engine/|nlohmann/|pugixml)', "a plugin includes what is the host's")
    yield from grep(files("host/sdk/*.hpp"), r"#include\s+[<\"]Eigen/", "an SDK header costs every plugin a second")
    yield from grep(files("plugins/*.cpp", "plugins/*.hpp", "host/*.cpp", "host/*.hpp"), r"\b(std::)?strto(d|f|ld)\(",
                    "numbers are read with from_chars")


def borders():
    """A plugin sees the SDK and its own folder, and asks the block rather than the contract."""
    for path in files("plugins/*.cpp", "plugins/*.hpp"):
        plugin = Path(*path.parts[:2])
        for number, line in lines(path):
            found = re.search(r'#include\s+"([^"]+)"', line)
            if found and not (ROOT / plugin / found[1]).is_file() and not (ROOT / path.parent / found[1]).is_file():
                yield f"{path}:{number}: includes what does not stand in its plugin: {found[1]}"
    own = [path for path in files("plugins/*.cpp", "plugins/*.hpp") if not path.stem.endswith("_test")]
    yield from grep(own, r"\bhost\(\)->\w+", "a call of the contract, for which Block has a verb")
    yield from grep(own, r"\b25\.4\b(?! times)|pi(_v<double>)? / 180|180 / std::numbers::pi", "isogloss/cnc/units.hpp has a name for it")
    yield from grep(own, r"\.substr\(8\)|\.integer = 1\b", "ig::word_name(), Block::raise() and ig::present say what is meant")


def machine_paths():
    """Nothing in the tree depends on where it was written."""
    text = [path for path in files() if path.suffix not in (".png", ".gz", ".bin")]
    yield from grep(text, r"(?<![\w./$}{-])/(home|root|work|tmp/[a-z]|Users|mnt|shared)/[\w.-]*", "a path of one machine")


def size():
    count = sum(1 for _ in lines(Path("host/abi/isogloss.h")))
    if count >= 500:
        yield f"host/abi/isogloss.h:{count}: the contract stays under 500 lines"


def strays():
    """What a command of a test or a try leaves in the folder in which it runs."""
    kept = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    for path in kept.split("\0"):
        if "/" not in path and path and path not in at_the_top:
            yield f"{path}:1: does not belong at the top of the project"


def versions():
    """The project's version is that of the newest dated section of the changelog, below an undated one."""
    project = re.search(r"^project\(isogloss VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(), re.M)[1]
    sections = [(number, line[3:]) for number, line in lines(Path("CHANGELOG.md")) if line.startswith("## ")]
    if [title for _, title in sections[:1]] != ["Unreleased"]:
        yield "CHANGELOG.md:1: its first section is not 'Unreleased'"
    for number, title in sections[1:2]:
        if not re.fullmatch(re.escape(project) + r" – \d{4}-\d{2}-\d{2}", title):
            yield f"CHANGELOG.md:{number}: the newest release is '{title}', and CMakeLists.txt says {project}"


def main():
    found = [breach for rule in (pages, boundaries, borders, machine_paths, size, strays, versions) for breach in rule()]
    print("\n".join(found), end="\n" if found else "")
    sys.exit(1 if found else 0)


main()
