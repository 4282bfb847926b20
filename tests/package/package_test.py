#!/usr/bin/env python3
"""The packages for Debian: their names, contents and relations, what lintian says, and whether they work unpacked.

  package_test.py --build FOLDER --source FOLDER --cpack PATH [--compiler PATH]
"""
import argparse
import gzip
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

from budget import FACTOR  # noqa: E402: it lies in another folder

OPTIONS = None
NAMES = ("isogloss", "isogloss-dev", "isogloss-dialects")


def run(*command, status=0, **more):
    # Nothing but what is packed may answer.
    environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_") and k != "LD_LIBRARY_PATH"}
    environment |= more.pop("env", {})
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False, timeout=600,
                          env=environment, **more)
    if status is not None and done.returncode != status:
        raise AssertionError(f"{command}: exit status {done.returncode}\n{done.stdout}{done.stderr}")
    return done


def pack(folder, **more):
    """All packages; `./dev test --random` compresses them as they ship, which takes two thirds of the time."""
    run(OPTIONS.cpack, "-G", "DEB", "-B", folder, "-D", f"CPACK_OUTPUT_FILE_PREFIX={folder}", "-D",
        f"CPACK_DEBIAN_COMPRESSION_TYPE={'xz' if FACTOR > 1 else 'gzip'}", cwd=OPTIONS.build, **more)


class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.path = pathlib.Path(folder.name).resolve()
        packages = cls.path / "packages"
        pack(packages)
        cls.files = {path.name.split("_")[0]: path for path in packages.glob("*.deb")}
        cls.root = cls.path / "root"
        for file in cls.files.values():
            run("dpkg-deb", "-x", file, cls.root)
        cls.command = cls.root / "usr/bin/isogloss"
        has_python = "ISOGLOSS_HAS_PYTHON:INTERNAL=ON" in (OPTIONS.build / "CMakeCache.txt").read_text()
        cls.names = NAMES + (("python3-isogloss",) if has_python else ())

    def field(self, package, name):
        return run("dpkg-deb", "-f", self.files[package], name).stdout.strip()

    def contents(self, package):
        listed = run("dpkg-deb", "-c", self.files[package]).stdout.splitlines()
        return [line.split(None, 5)[5].removeprefix("./") for line in listed if not line.startswith("d")]

    def test_names_versions_and_relations(self):
        self.assertEqual(sorted(self.files), sorted(self.names))
        architecture = run("dpkg", "--print-architecture").stdout.strip()
        version = self.field("isogloss", "Version")
        project = re.search(r"^project\(isogloss VERSION (\S+)", (OPTIONS.source / "CMakeLists.txt").read_text(), re.M)[1]
        self.assertRegex(version, rf"^{re.escape(project)}(\+git[0-9.]+)?-1$")
        for package, of in (("isogloss", architecture), ("isogloss-dev", architecture), ("isogloss-dialects", "all")):
            self.assertEqual(self.field(package, "Architecture"), of)
            self.assertEqual(self.field(package, "Version"), version)
            self.assertEqual(self.files[package].name, f"{package}_{version}_{of}.deb")
        needed = self.field("isogloss", "Depends")
        for library in ("libc6 (>=", "libfmt9 (>=", "libpugixml1v5 (>=", "libstdc++6 (>=", f"isogloss-dialects (= {version})"):
            self.assertIn(library, needed)
        self.assertIn(f"isogloss (= {version})", self.field("isogloss-dev", "Depends"))

    def test_the_same_build_gives_the_same_bytes(self):
        """Packed again at another time, into another folder, in another time zone."""
        again = self.path / "again"
        pack(again, env={"TZ": "Asia/Tokyo"})
        for name, file in self.files.items():
            other = again / file.name
            self.assertTrue(other.is_file(), f"{name}: {sorted(again.glob('*.deb'))}")
            self.assertEqual(file.read_bytes(), other.read_bytes(), f"{name} differs: diffoscope {file} {other}")

    def test_everything_that_is_installed_is_in_one_package(self):
        prefix = self.path / "installed"
        run("cmake", "--install", OPTIONS.build, "--prefix", prefix)
        triplet = run("dpkg-architecture", "-qDEB_HOST_MULTIARCH").stdout.strip()
        installed = {f"usr/{path.relative_to(prefix)}" for path in prefix.rglob("*") if path.is_file()}
        moved = {re.sub(r"^(usr/share/man/.*)", r"\1.gz", file.replace("zsh/site-functions", "zsh/vendor-completions")
                        .replace("lib/pkgconfig", f"lib/{triplet}/pkgconfig")) for file in installed}
        moved -= {"usr/share/doc/isogloss/LICENSE", "usr/share/doc/isogloss/CHANGELOG.md"}
        packed = [file for name in self.names for file in self.contents(name)]
        self.assertEqual(len(packed), len(set(packed)), "no file is in two packages")
        added = {f"usr/share/{file}" for name in self.names
                 for file in (f"doc/{name}/copyright", f"doc/{name}/changelog.gz", f"doc/{name}/changelog.Debian.gz",
                              f"lintian/overrides/{name}")}
        self.assertEqual(sorted(moved | added), sorted(packed))

    def test_the_parts_are_where_they_belong(self):
        dialects = self.contents("isogloss-dialects")
        self.assertTrue(all(file.startswith(("usr/share/isogloss/dialects/", "usr/share/doc/isogloss-dialects/",
                                             "usr/share/lintian/")) for file in dialects), dialects)
        for file in ("usr/include/isogloss.h", "usr/lib/libisogloss_engine.a", "usr/share/isogloss/schemas/dialect.xsd",
                     "usr/lib/cmake/isogloss/isoglossConfig.cmake", "usr/share/doc/isogloss/examples/vendor/plugin.cpp"):
            self.assertIn(file, self.contents("isogloss-dev"))
        for file in ("usr/bin/isogloss", "usr/lib/isogloss/plugins/iso.so", "usr/share/man/man1/isogloss-run.1.gz",
                     "usr/share/bash-completion/completions/isogloss", "usr/share/zsh/vendor-completions/_isogloss",
                     "usr/share/fish/vendor_completions.d/isogloss.fish"):
            self.assertIn(file, self.contents("isogloss"))

    def test_lintian_has_no_error_and_no_warning(self):
        if shutil.which("lintian") is None:
            self.skipTest("lintian is not installed: ./dev package installs it")
        done = run("lintian", "--allow-root", "--fail-on", "error,warning", *self.files.values(), status=None,
                   env={"LC_ALL": "C.UTF-8"})
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stdout + done.stderr)

    def test_each_command_has_a_manual_page(self):
        pages = {path.name: gzip.open(path, "rt").read() for path in (self.root / "usr/share/man/man1").glob("*.gz")}
        shown = run(self.command, "--help").stdout.split("Commands:\n")[1].split("\n\n")[0]
        for name in (line.split()[0] for line in shown.splitlines()):
            page = pages[f"isogloss-{name}.1.gz"]
            options = re.findall(r"^  (?:-\w,)?(--[\w-]+)", run(self.command, name, "--help").stdout, re.M)
            for option in options:
                self.assertIn("\\fB" + option.replace("-", "\\-") + "\\fR", page, f"{name} {option}")
        self.assertIn("ISOGLOSS_PLUGIN_PATH", pages["isogloss.1.gz"])
        # What the readers of manual pages complain about.
        for name, page in pages.items():
            file = self.path / name.removesuffix(".gz")
            file.write_text(page)
            if shutil.which("mandoc"):
                run("mandoc", "-T", "lint", "-W", "warning", file)
            if shutil.which("man"):
                done = run("man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", file, env={"LC_ALL": "C.UTF-8"})
                self.assertEqual(done.stderr, "", name)

    def test_the_unpacked_command_finds_its_parts(self):
        program = self.path / "line.nc"
        program.write_text("G21 G90 G54 G0 X1.\nM30\n")
        for more in (["-d", "fanuc"], ["-m", "fanuc-mill"], ["-d", "heidenhain"]):
            listed = run(self.command, "run", program, *more, "--emit", "none", "--summary", status=None)
            self.assertLess(listed.returncode, 2, listed.stderr)
        self.assertEqual(run(self.command, "doctor", "--json").returncode, 0)
        run(self.command, "lint", "fanuc", "siemens", "heidenhain")

    def test_the_unpacked_module_finds_its_parts(self):
        if "python3-isogloss" not in self.names:
            self.skipTest("the Python module was not built")
        for relation in (f"isogloss (= {self.field('isogloss', 'Version')})", "python3-numpy", "python3 (<<"):
            self.assertIn(relation, self.field("python3-isogloss", "Depends"))
        script = "import isogloss; print(isogloss.run(text='G21 G90 G0 X1.\\nM30\\n', dialect='fanuc').lines)"
        done = run("/usr/bin/python3", "-c", script, env={"PYTHONPATH": self.root / "usr/lib/python3/dist-packages"})
        self.assertEqual(done.stdout, "[1 2]\n")
        exported = run("nm", "-D", "--defined-only", *self.root.glob("usr/lib/python3/dist-packages/isogloss/*.so")).stdout
        self.assertEqual([line.split()[-1] for line in exported.splitlines()], ["PyInit__isogloss"])

    def test_a_vendor_builds_with_the_packages(self):
        examples = self.root / "usr/share/doc/isogloss/examples"
        tree = self.path / "vendor"
        run("cmake", "-S", examples / "vendor", "-B", tree, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={self.root}/usr",
            f"-DCMAKE_CXX_COMPILER={OPTIONS.compiler}")
        run("cmake", "--build", tree)
        self.assertIn("acme", run(self.command, "list", "plugins", "--plugins", tree / "plugins").stdout)
        # As Debian's own builds of packages do.
        run("strip", "--strip-unneeded", tree / "plugins/acme.so")
        self.assertIn("acme", run(self.command, "list", "plugins", "--plugins", tree / "plugins").stdout)

    def test_pkg_config_finds_the_unpacked_headers(self):
        if shutil.which("pkg-config") is None:
            self.skipTest("pkg-config is not installed")
        folder = next((self.root / "usr/lib").glob("*/pkgconfig"))
        done = run("pkg-config", "--cflags", "isogloss", env={"PKG_CONFIG_PATH": str(folder)})
        named = pathlib.Path(done.stdout.strip().removeprefix("-I")).resolve()
        self.assertEqual(named, self.root / "usr/include")

    def test_shells_find_the_completions(self):
        environment = {"XDG_DATA_DIRS": f"{self.root}/usr/share:/usr/share", "HOME": str(self.path),
                       "PATH": f"{self.root}/usr/bin:{os.environ['PATH']}"}
        library = pathlib.Path("/usr/share/bash-completion/bash_completion")
        if library.is_file():
            done = run("bash", "-c", f"source {library}; _completion_loader isogloss; complete -p isogloss", env=environment)
            self.assertEqual(done.stdout, "complete -F _isogloss isogloss\n")
        if shutil.which("fish"):
            done = run("fish", "-c", "complete -C 'isogloss run -d fanu'", env=environment)
            self.assertEqual(done.stdout.split("\t")[0], "fanuc")


def main():
    global OPTIONS
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--build", type=pathlib.Path, required=True)
    arguments.add_argument("--source", type=pathlib.Path, required=True)
    arguments.add_argument("--cpack", default="cpack")
    arguments.add_argument("--compiler", default="c++")
    OPTIONS, rest = arguments.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])


main()
