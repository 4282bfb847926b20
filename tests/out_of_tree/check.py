#!/usr/bin/env python3
"""Installs Isogloss into a fresh folder and builds projects against that installation alone."""
import argparse
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent

EMBED_MOTIONS = """\
file,line,event,px,py,pz,mx,my,mz,a,b,c,feed_mm_s,cx,cy,cz,ccw,circles,plane,mcx,mcy,mcz,nx,ny,nz,sweep,value,term
in memory,2,rapid,10,20,5,10,20,5,,,,,,,,,,,,,,,,,,,
in memory,3,feed,10,20,-1,10,20,-1,,,,10,,,,,,,,,,,,,,,
in memory,4,arc,20,30,-1,20,30,-1,,,,10,10,30,-1,1,0,XY,10,30,-1,0,0,1,90,,
in memory,5,end,,,,,,,,,,,,,,,,,,,,,,,,,M30
"""

EMBED_PATHS = """\
4 events, 6 mm by feed, 90 deg of arcs, M30
2 events, 50 mm by feed, 0 deg of arcs, M00
X20 Y30 Z-1
"""


# How a canned cycle is called; G81x is its code.
CYCLE_PROGRAMS = (
    ("it is modal", "G98 G81x X10. Y10. Z-5. R2. F100\nX60.\nY20. Z-8.\nG80\nX0."),
    ("G99 and G98", "G99 G81x X10. Z-5. R2. F100\nG98 X20.\nG99 X30.\nG80"),
    ("G91", "G91 G81x X10. Y5. Z-7. R-45. F100\nX10.\nG80\nG90"),
    ("repeats by K", "G91 G99 G81x X10. Z-7. R-45. F100 K3\nG80"),
    ("repeats by L", "G91 G99 G81x X10. Z-7. R-45. F100 L3\nG80"),
    ("a motion code ends it", "G81x X10. Z-5. R2. F100\nG1 X20.\nX30."),
    ("another cycle follows, and is followed", "G81x X10. Z-5. R2. F100\nG83 X20. Q3.\nG81x X30.\nG80"),
    ("G18", "G18 G81x X10. Y-5. R2. Z5. F100\nX20.\nG80"),
    ("G19", "G19 G81x X-10. Y-5. R2. Z5. F100\nY20.\nG80"),
    ("inches", "G20\nG81x X1. Z-.5 R.1 F10.\nX2.\nG80"),
    ("scaled, mirrored and turned", "G68 X0 Y0 R30.\nG51.1 X0.\nG81x X10. Y3. Z-5. R2. F100\nG80"),
    ("no F is reported", "G81x X10. Z-5. R2.\nG80"),
    ("no R is reported", "G81x X10. Z-5. F100\nG80"))


class Checks:
    def __init__(self, options):
        self.build = options.build
        self.folder = options.folder
        self.compiler = options.compiler
        self.prefix = self.folder / "installed"
        self.command = self.prefix / "bin" / "isogloss"

    def run(self, *command, status=0):
        # Only the installation and what a test names itself count, not the caller's own plugins.
        environment = {key: value for key, value in os.environ.items() if not key.startswith("ISOGLOSS_")}
        done = subprocess.run([str(part) for part in command], capture_output=True, text=True, env=environment,
                              cwd=self.folder)
        if done.returncode != status:
            sys.exit(f"{' '.join(map(str, command))}\nexit status {done.returncode}, expected {status}\n"
                     f"{done.stdout}{done.stderr}")
        return done

    def build_project(self, name, *definitions, status=0):
        folder = self.folder / name
        shutil.rmtree(folder, ignore_errors=True)
        self.run("cmake", "-S", HERE / name, "-B", folder, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={self.compiler}",
                 f"-DCMAKE_PREFIX_PATH={self.prefix}", "-DCMAKE_BUILD_TYPE=Release", *definitions)
        return folder, self.run("cmake", "--build", folder, status=status)

    def install(self):
        shutil.rmtree(self.prefix, ignore_errors=True)
        self.run("cmake", "--install", self.build, "--strip", "--prefix", self.prefix)  # as ./dev install does
        program = self.folder / "line.nc"
        program.write_text("G90 G54 G0 X1.\nM30\n")
        motions = self.run(self.command, "run", program, "-d", "fanuc", "--emit", "motions", "--format", "csv").stdout
        expect(",1,rapid,1," in motions, "the installed command finds its plugins and dialects", motions)
        motions = self.run(self.command, "run", program, "-d", "fanuc", "--machine", "ac-table", "--emit", "motions",
                           "--format", "csv").stdout
        expect(",1,rapid,1," in motions, "and its machines", motions)
        program.write_text("G21 G90 G54 G43 H2 Z0\nM60\nM30\n")  # M60 calls a program of the machine
        motions = self.run(self.command, "run", program, "-m", "fanuc-mill", "--emit", "motions", "--format", "csv").stdout
        expect(",-380,-60,0," in motions, "and the files of a machine", motions)
        documents = self.prefix / "share" / "doc" / "isogloss"
        missing = [name for name in ("README.md", "LICENSE", "examples/vendor/plugin.cpp", "examples/embed/main.cpp")
                   if not (documents / name).is_file()]
        expect(not missing, "the first page and the examples are installed", missing)

    def embed(self):
        folder, _ = self.build_project("embed")
        motions = self.run(folder / "embed", self.prefix, "fanuc").stdout
        expect(motions == EMBED_MOTIONS, "a program that embeds the host gets its motions", motions)
        paths = self.run(folder / "motions", self.prefix, "fanuc").stdout
        expect(paths == EMBED_PATHS, "and as values, from several threads that share a linked dialect", paths)

    def vendor(self):
        # What the engine needs, a plugin does not.
        folder, _ = self.build_project("vendor", *(f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON"
                                                   for name in ("fmt", "nlohmann_json", "pugixml")))
        plugins = folder / "plugins"
        listed = json.loads(self.run(self.command, "list", "syntaxes", "--plugins", plugins, "--json").stdout)
        expect("AcmeVacuumSyntax" in json.dumps(listed), "the vendor's syntax is listed", listed)
        page = self.run(self.command, "inspect", "AcmeVacuumSyntax", "--plugins", plugins).stdout
        expect("M171 switches the vacuum table on" in page, "its page is in the plugin", page)
        self.run(self.command, "case", HERE / "vendor" / "acme_vacuum_syntax.md", "--plugins", plugins)
        shutil.rmtree(self.folder / "reference", ignore_errors=True)
        done = self.run(self.command, "docs", "-o", self.folder / "reference", "--plugins", plugins, "--dialects",
                        HERE / "vendor")
        expect("M171 switches the vacuum table on" in
               (self.folder / "reference" / "pages" / "acme_vacuum_syntax.html").read_text() and not done.stderr,
               "it stands in the reference that the installed command writes", done)
        program = self.folder / "vacuum.acme"
        program.write_text("M171\nG0 X1.\nM172\nM30\n")
        blocks = self.run(self.command, "run", program, "-d", "acme", "--plugins", plugins, "--dialects",
                          HERE / "vendor", "--emit", "blocks").stdout.splitlines()
        held = [json.loads(line).get("AcmeVacuum", {}).get("IsOn") for line in blocks]
        expect(held[:3] == [True, True, False], "a vendor's dialect runs the vendor's syntax", blocks)

        self.vendor_cycle(plugins)
        self.vendor_importer(plugins)
        self.build_beside_the_sources()

    def build_beside_the_sources(self):
        """`cmake -B build` in the plugin's own folder, as most do, and a second build tree beside the first."""
        sources = self.folder / "own"
        shutil.rmtree(sources, ignore_errors=True)
        shutil.copytree(HERE / "vendor", sources)
        for tree in ("build", "build-debug", "build"):
            self.run("cmake", "-S", sources, "-B", sources / tree, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={self.prefix}",
                     f"-DCMAKE_CXX_COMPILER={self.compiler}")
            self.run("cmake", "--build", sources / tree)
            expect((sources / tree / "plugins" / "acme.so").is_file(), f"the plugin is built in {tree}", tree)
        shutil.copy(sources / "acme_vacuum_syntax.md", sources / "build-debug" / "acme_vacuum_syntax.md")
        self.run("cmake", "--build", sources / "build")
        (sources / "room").mkdir()
        shutil.copy(sources / "acme_vacuum_syntax.md", sources / "room" / "acme_vacuum_syntax.md")
        done = subprocess.run(["cmake", "--build", sources / "build"], capture_output=True, text=True)
        expect(done.returncode != 0 and "two pages have one name" in done.stdout + done.stderr,
               "two pages of one name are refused", done)

    def same_cycle_in_c(self, folder):
        """The cycle that `new` writes in C makes the moves of the one in C++, and says the same."""
        start = "G90 G54 G17 G21 G94 S500 M3\nG0 X0. Y0. Z50.\n"
        for name, body in (
                *((name, body.replace("G81x", "G181")) for name, body in CYCLE_PROGRAMS),
                ("a dwell", "G181 X10. Z-5. R2. P500 F100\nX20.\nG80"),
                ("a negative dwell", "G181 X10. Z-5. R2. P-500 F100\nG80"),
                ("words without effect", "G181 X10. Z-5. R2. Q3. I1. J2. F100\nX20. Q4.\nG80"),
                ("F0", "G181 X10. Z-5. R2. F0\nG80"),
                ("G93", "G93\nG181 X10. Z-5. R2. F10\nX20. F5\nX30.\nG80"),
                ("G95", "G95\nG181 X10. Z-5. R2. F.1\nG80"),
                ("G95 without a spindle speed", "S0\nG95\nG181 X10. Z-5. R2. F.1\nG80"),
                ("a feed that a change of mode ended", "F100\nG95\nG181 X10. Z-5. R2.\nG80"),
                ("no depth", "G181 X10. Y10. Z2. R2. F100\nG80"),
                ("polar repeats", "G16\nG91 G181 X20. Y30. Z-7. R-45. F100 K4\nG80\nG15\nG90"),
                ("polar repeats, scaled and mirrored",
                 "G51 X5. Y5. P2.\nG51.1 X3.\nG16\nG91 G181 X20. Y30. Z-7. R-45. F100 K4\nG80\nG15"),
                ("a frame that changes beside it", "G55 G181 X10. Z-5. R2. F100\nG54 X20.\nG80")):
            program = self.folder / "cycle.nc"
            program.write_text(start + body + "\nM30\n")
            answers = []
            for plugin in ("acme-drill", "acme-drill-c"):
                place = folder / plugin
                done = subprocess.run([self.command, "run", program, "-d", plugin, "--plugins", place / "build/plugins",
                                       "--dialects", place / "dialects", "--format", "csv", "--set",
                                       "IsoCoordinateTable.G55.X=7"], capture_output=True, text=True, cwd=self.folder)
                answers.append((done.returncode, done.stdout, done.stderr))
            expect(answers[0] == answers[1], f"a cycle in C: {name}", answers)
            expect(any(sign in answers[0][1] + answers[0][2] for sign in (",feed,", "error: ", "warning: ")),
                   "and something came of it", answers)

    def vendor_cycle(self, plugins):
        """G181 of the vendor is one of the canned cycles: without P it makes the moves of G85, wherever it stands."""
        self.run(self.command, "case", HERE / "vendor" / "acme_dimple_cycle_syntax.md", "--plugins", plugins)
        start = "G90 G54 G17 G21 G94 S500 M3\nG0 X0. Y0. Z50.\n"
        for name, body in CYCLE_PROGRAMS:
            answers = []
            for code in ("G85", "G181"):
                program = self.folder / "cycle.acme"
                program.write_text(start + body.replace("G81x", code) + "\nM30\n")
                done = subprocess.run([self.command, "run", program, "-d", "acme", "--plugins", plugins, "--dialects",
                                       HERE / "vendor", "--emit", "motions", "--format", "csv"], capture_output=True,
                                      text=True, cwd=self.folder)
                answers.append((done.returncode, (done.stdout + done.stderr).replace(code, "G81x")))
            # Columns differ by the length of the code, the moves do not.
            plain = [(status, re.sub(r":(\d+):\d+:", r":\1:", text)) for status, text in answers]
            expect(plain[0] == plain[1], f"a vendor's cycle: {name}", answers)
            expect(("error: " if "reported" in name else ",feed,") in plain[0][1], "and something came of it", answers)

    def vendor_importer(self, plugins):
        self.run(self.command, "case", HERE / "vendor" / "acme_tool_file.md", "--plugins", plugins)
        table = self.folder / "mill.acmetools"
        table.write_text("ACME TOOLS\n12 98.2 5\n")
        tables = self.run(self.command, "import", table, "--plugins", plugins).stdout
        expect('<Tool id="12" H="98.2" D="5" />' in tables, "a vendor's importer reads the vendor's file", tables)

    def new(self):
        """What `isogloss new` writes is green at once, and its tests notice a change."""
        folder = self.folder / "new"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        for name, what, *more in (("acme-drill", "plugin", "--cycle", "G181"), ("acme-drill-c", "plugin", "--cycle", "G181", "--language", "c"),
                                  ("acme-word", "plugin", "--word", "E"),
                                  ("acme-c", "plugin", "--word", "E", "--language", "c"),
                                  ("acme-table", "plugin", "--table", "ClampTable"),
                                  ("acme-c-table", "plugin", "--table", "ClampTable", "--language", "c"),
                                  ("acme-840d-c", "plugin", "--table", "ClampTable", "--language", "c", "--extends", "siemens"),
                                  ("acme-switch", "plugin", "--switch", "M171,M172", "--extends", "siemens"),
                                  ("acme-switch-c", "plugin", "--switch", "M171,M172", "--language", "c"),
                                  ("acme-tnc-c", "plugin", "--language", "c", "--extends", "heidenhain"),
                                  ("acme-tnc-word", "plugin", "--word", "E", "--extends", "heidenhain"),
                                  ("acme-tnc-table", "plugin", "--table", "ClampTable", "--language", "c", "--extends",
                                   "heidenhain"),
                                  ("acme-iso", "dialect"),
                                  ("acme-840d", "dialect", "--extends", "siemens"),
                                  ("acme-tnc", "dialect", "--extends", "heidenhain")):
            self.run(self.command, "new", what, name, "--in", folder, *more)
            place, tree = folder / name, folder / name / "build"
            self.run("cmake", "-S", place, "-B", tree, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={self.prefix}",
                     *([] if "c" in more or what == "dialect" else [f"-DCMAKE_CXX_COMPILER={self.compiler}"]),
                     "-DCMAKE_COMPILE_WARNING_AS_ERROR=ON")
            self.run("cmake", "--build", tree)
            passed = self.run("ctest", "--test-dir", tree, "--output-on-failure").stdout
            counted = int(re.search(r"out of (\d+)", passed)[1])
            expect(counted == (2 if what == "dialect" else 5 if "acme-tnc-" in name and name != "acme-tnc-c" else 4),
                   f"{name}: pages, dialect, program and contract are tested", passed)

            expected = next((place / "tests").glob("*.expected"))
            text = expected.read_text()
            expected.write_text(text + "one line more\n")
            self.run("ctest", "--test-dir", tree, "-R", "program", status=8)
            self.run("cmake", "--build", tree, "--target", f"update-{expected.stem}")
            expect(expected.read_text() == text, f"{name}: its test fails on a change, and what is expected is written", "")

        drilled = self.folder / "new/acme-drill/tests/g181.expected"
        feeds = re.findall(r",3,feed,10,20,(\S+?),.*?,,,,(\d+),", drilled.read_text())
        expect(feeds == [("-3", "2"), ("2", "1")], "G181 feeds to the bottom and returns at half feed", feeds)
        self.same_cycle_in_c(folder)
        self.packed(folder)
        self.validated(folder)
        place = folder / "acme-drill"
        page = place / "acme_drill_g181_cycle_syntax.md"
        text = page.read_text()
        page.write_text(text.replace('"Time": 0.5', '"Time": 0.7'))
        failed = self.run("ctest", "--test-dir", place / "build", "-R", "page", "--output-on-failure", status=8).stdout
        expect("Dwell.Time: expected 0.7, got 0.5" in failed, "a case that fails shows the first paths that differ", failed)
        expect("the document after the build" not in failed, "and not the whole document", failed)
        page.write_text(text)
        self.nothing_is_missed(place)

    def nothing_is_missed(self, place):
        """A syntax without a page, one without a case, and a page of another name."""
        tree, page = place / "build", place / "acme_drill_g181_cycle_syntax.md"
        text = page.read_text()
        for changed in ("# AcmeDrillG181CycleSyntax\n\nThe cycle.\n", None):
            page.unlink() if changed is None else page.write_text(changed)
            self.run("cmake", "--build", tree)
            failed = self.run("ctest", "--test-dir", tree, "-R", "validate", "--output-on-failure", status=8).stdout
            expect("has no page with a case" in failed, "a syntax without a page or a case fails", failed)
        other = place / "acme_drill_g181_syntax.md"
        other.write_text(text)
        failed = self.run("cmake", "--build", tree, status=1).stdout
        expect("acme_drill_g181_cycle_syntax.md" in failed, "a page of another name is refused", failed)
        other.unlink()
        page.write_text(text)
        self.run("cmake", "--build", tree)

    def packed(self, folder):
        """cpack makes a package, whose files the installation of isogloss finds."""
        for name, architecture in (("acme-drill-c", None), ("acme-tnc", "all")):
            tree = folder / name / "build"
            self.run("cpack", "--config", tree / "CPackConfig.cmake", "-B", tree / "packages")
            package, = (tree / "packages").glob("*.deb")
            listed = self.run("dpkg-deb", "-c", package).stdout if shutil.which("dpkg-deb") else None
            if listed is None:
                continue
            expect(f"./usr/share/isogloss/dialects/{name}.xml" in listed, f"{package.name} holds the dialect", listed)
            expect((f"./usr/lib/isogloss/plugins/{name}.so" in listed) == (architecture is None), "and the plugin", listed)
            for document in ("copyright", "changelog.gz"):
                expect(f"./usr/share/doc/isogloss-{name}/{document}" in listed, f"and its {document}", listed)
            needs = self.run("dpkg-deb", "-f", package, "Depends").stdout
            version = self.run(self.command, "--version").stdout.split()[1]
            expect(f"isogloss-dialects (>= {version})" in needs, "it needs the dialects, of a version", needs)
            if architecture is None:
                expect(f"isogloss (>= {version})" in needs, "and the command", needs)
                expect("libc6" in needs or shutil.which("dpkg-shlibdeps") is None, "and the libraries of the plugin", needs)

    def validated(self, folder):
        """Lint has no warning for the dialects, and the plugins of new templates keep the contract, its advice too."""
        for plugin in sorted(folder.glob("*/build/plugins/*.so")):
            name, place = plugin.stem, plugin.parents[2]
            done = self.run(self.command, "lint", name, "--plugins", plugin.parent, "--dialects", place / "dialects")
            expect("warning" not in done.stdout + done.stderr, f"{name}: lint has no warning", done)
            if name not in ("acme-drill", "acme-drill-c", "acme-tnc-word", "acme-tnc-table"):
                continue  # its own tests have run what must hold
            done = subprocess.run([self.command, "validate", plugin, "--strict", "--blocks", "500", "--json"],
                                  capture_output=True, text=True)
            checks = json.loads(done.stdout)["Plugins"][0]["Checks"]
            # A busy machine makes a plugin slow.
            failed = [c for c in checks if c["Result"] == "failed" and c["Level"] != "note"
                      and c["Name"] not in ("load-time", "time")]
            expect(not failed and len(checks) > 20, f"{name} keeps the contract", failed)

    def pkg_config(self):
        """Without CMake: isogloss.pc, also where the installation was moved to."""
        if shutil.which("pkg-config") is None:
            print("skipped: pkg-config is not installed")
            return
        moved = self.folder / "moved"
        shutil.rmtree(moved, ignore_errors=True)
        shutil.copytree(self.prefix, moved)
        os.environ["PKG_CONFIG_PATH"] = str(moved / "lib" / "pkgconfig")

        def ask(*what):
            return self.run("pkg-config", *what, "isogloss").stdout.split()

        version = self.run(self.command, "--version").stdout.split()[1]
        expect(ask("--modversion") == [version], "isogloss.pc has the version of the command", ask("--modversion"))
        expect(Path(ask("--variable=plugindir")[0]).resolve() == moved / "lib/isogloss/plugins", "and knows the plugins", "")
        program = self.folder / "embed_without_cmake"
        self.run(self.compiler, "-std=c++20", HERE / "embed" / "main.cpp", *ask("--cflags"), *ask("--libs"), "-o", program)
        motions = self.run(program, moved, "fanuc").stdout
        expect(motions == EMBED_MOTIONS, "a program that embeds the host is built", motions)

        shutil.rmtree(self.folder / "acme-pc", ignore_errors=True)
        self.run(self.command, "new", "plugin", "acme-pc", "--word", "E", "--language", "c", "--in", self.folder)
        place, tools = self.folder / "acme-pc", moved / "lib" / "cmake" / "isogloss"
        pages = ";".join(str(path) for path in sorted(place.glob("*_syntax.md")))
        self.run("cmake", "-D", f"OUTPUT={place / 'pages.c'}", "-D", f"PAGES={pages}", "-P", tools / "EmbedPagesInC.cmake")
        self.run("cc", "-std=c11", "-fPIC", "-shared", *ask("--cflags"), f"-Wl,--version-script={tools / 'plugin.map'}",
                 *sorted(place.glob("*.c")), "-o", place / "acme-pc.so")
        listed = self.run(moved / "bin" / "isogloss", "list", "syntaxes", "--plugins", place).stdout
        expect("acme-pc" in listed, "and a plugin in C", listed)

    def without_entry(self):
        _, done = self.build_project("without_entry", status=1)
        said = " ".join(done.stdout.split())  # lines break where the path ends
        expect("does not export ig_plugin_v1" in said, "a plugin without an entry does not build", done.stdout)


def expect(holds, what, seen):
    if not holds:
        sys.exit(f"not so: {what}\n{seen}")
    print(what)


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("check", choices=["install", "embed", "vendor", "new", "pkg_config", "without_entry"])
    arguments.add_argument("--build", type=Path, required=True)
    arguments.add_argument("--folder", type=Path, required=True)
    arguments.add_argument("--compiler", default="c++")
    options = arguments.parse_args()
    getattr(Checks(options), options.check)()


main()
