#!/usr/bin/env python3
"""One plugin as vendors build it: in C alone, against the first version of the contract, and by clang with a C++ library
of its own. Each is built here by the compiler alone, loads, keeps the contract, and runs the same program alike.

  vendor_test.py --isogloss PATH --cc CC --cxx CXX --cmake CMAKE
"""
import argparse
import hashlib
import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

OPTIONS = None
HERE = pathlib.Path(__file__).resolve().parent
HOST = HERE.parents[1] / "host"
FIRST = HERE / "contract-1.0"
PAGES = sorted((HERE / "pages").glob("*.md"))
LINK = ["-shared", "-Wl,-z,defs", "-Wl,-z,now", f"-Wl,--version-script={HOST}/sdk/cmake/plugin.map"]
STRICT = ["-O2", "-fPIC", "-fvisibility=hidden", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]
STATIC = ["-static-libstdc++", "-static-libgcc"]

# What clamps.nc makes of the vendor's sections, block by block, and what it says.
SECTIONS = [("north", True, None), ("north", True, 12.5), ("north", True, 12.5), ("north", False, 12.5),
            ("north", False, 12.5), ("north", False, 12.5), ("north", False, 12.5)]
SAID = ["clamps.nc:4:1: warning: M171 and M172 stand in one block: the last one counts [ACME-0001]",
        "clamps.nc:5:1: error: E4: there is no such clamp, so the previous force stays in force [ACME-0002]"]


def needed(library):
    """The libraries that a 64-bit ELF file needs: the DT_NEEDED entries of its dynamic section."""
    data = library.read_bytes()
    offset, = struct.unpack_from("<Q", data, 40)
    size, count = struct.unpack_from("<HH", data, 58)
    headers = [struct.unpack_from("<IIQQQQIIQQ", data, offset + i * size) for i in range(count)]
    dynamic = next(h for h in headers if h[1] == 6)
    strings = headers[dynamic[6]][4]
    entries = struct.iter_unpack("<QQ", data[dynamic[4]:dynamic[4] + dynamic[5]])
    names = [strings + value for tag, value in entries if tag == 1]
    return [data[name:data.index(b"\0", name)].decode() for name in names]


class Vendor(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def run_it(self, *command, status=0):
        environment = {k: v for k, v in os.environ.items() if not k.startswith("ISOGLOSS_")}
        done = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=300, check=False,
                              cwd=HERE, env=environment)
        self.assertEqual(done.returncode, status, f"{command}\n{done.stdout}\n{done.stderr}")
        return done

    def pages(self, script, extension):
        out = self.path / f"pages.{extension}"
        self.run_it(OPTIONS.cmake, "-D", f"OUTPUT={out}", "-D", f"ROOT={HERE}/pages", "-D",
                    "PAGES=" + ";".join(map(str, PAGES)), "-P", script)
        return out

    def build_in_c(self, compiler, contract):
        sources = [*sorted((HERE / "c").glob("*.c")), self.pages(HOST / "sdk/cmake/EmbedPagesInC.cmake", "c")]
        self.run_it(compiler, "-std=c11", *STRICT, f"-I{contract}", *LINK, "-o", self.path / "acme.so", *sources)

    def build_in_cxx(self, compiler, *options):
        sources = [*sorted((HERE / "cxx").glob("*.cpp")), self.pages(FIRST / "EmbedPages.cmake", "cpp")]
        unique = [] if "clang" in pathlib.Path(compiler).name else ["-fno-gnu-unique"]
        self.run_it(compiler, "-std=c++20", *STRICT, *unique, f"-isystem{FIRST}", *LINK, *options, "-o",
                    self.path / "acme.so", *sources)

    def isogloss(self, *arguments, status=0):
        return self.run_it(OPTIONS.isogloss, *arguments, "--plugins", self.path, "--dialects", HERE, status=status)

    def check(self, minor):
        """It loads with this version, keeps the contract, and the program gives what it gives with the others."""
        listed = json.loads(self.isogloss("list", "plugins", "--json").stdout)
        self.assertIn(minor, next(json.dumps(p) for p in listed if p.get("Name") == "acme"))
        valid = self.run_it(OPTIONS.isogloss, "validate", self.path / "acme.so", "--blocks", 500, "--json")
        checks = json.loads(valid.stdout)["Plugins"][0]["Checks"]
        # A busy machine makes it slow, and a table needs no page.
        self.assertEqual([c for c in checks if c["Result"] != "held" and c["Level"] == "must"], [])
        self.assertIn("held", [c["Result"] for c in checks if c["Name"] == "exports"])
        done = self.isogloss("run", "clamps.nc", "-d", "acme", "--emit", "blocks", status=1)
        blocks = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([(b["AcmeVacuum"]["Pump"], b["AcmeVacuum"]["IsOn"], b.get("AcmeClamp", {}).get("Force_kN"))
                          for b in blocks], SECTIONS)
        for text in SAID:
            self.assertIn(text, done.stderr)
        self.assertNotIn("IG-04", done.stderr)
        motions = self.isogloss("run", "clamps.nc", "-d", "acme", "--format", "csv", status=1).stdout.splitlines()
        plain = self.run_it(OPTIONS.isogloss, "run", "clamps.nc", "-d", "fanuc", "--format", "csv").stdout
        self.assertEqual(motions, plain.splitlines(), "the moves are those of the base dialect")
        self.refuses_a_pump()

    def refuses_a_pump(self):
        """What create() says, by a return value or by an exception, is the reason at the place in the dialect."""
        other = self.path / "west.xml"
        text = (HERE / "acme.xml").read_text().replace("<AcmeVacuumSyntax/>", '<AcmeVacuumSyntax pump="west"/>')
        other.write_text(text.replace('name="acme"', 'name="west"', 1))
        done = self.run_it(OPTIONS.isogloss, "run", "clamps.nc", "-d", other, "--plugins", self.path, status=2)
        self.assertIn("the machine has the pumps north and south", done.stderr)

    def clang(self, name):
        found = shutil.which(name)
        if found is None:
            self.skipTest(f"{name} is not installed")
        return found

    def test_in_c_alone(self):
        self.build_in_c(OPTIONS.cc, HOST / "abi")
        self.assertEqual([name for name in needed(self.path / "acme.so") if "++" in name], [])
        self.check(self.version(HOST / "abi"))

    def test_in_c_by_clang(self):
        self.build_in_c(self.clang("clang"), HOST / "abi")
        self.check(self.version(HOST / "abi"))

    def test_in_c_of_the_first_contract(self):
        self.build_in_c(OPTIONS.cc, FIRST)
        self.check("1.0")

    def test_of_the_first_contract_and_sdk(self):
        self.build_in_cxx(OPTIONS.cxx)
        self.check("1.0")

    def test_by_clang_with_a_static_library(self):
        self.build_in_cxx(self.clang("clang++"), *STATIC)
        self.assertEqual([name for name in needed(self.path / "acme.so") if "++" in name or "gcc" in name], [])
        self.check("1.0")

    def test_by_clang_with_a_static_library_and_the_sdk_of_today(self):
        compiler = self.clang("clang++")
        vendor = HERE.parent / "out_of_tree/vendor"
        pages = self.path / "pages.cpp"
        self.run_it(OPTIONS.cmake, "-D", f"OUTPUT={pages}", "-D", f"ROOT={vendor}", "-D",
                    "PAGES=" + ";".join(map(str, sorted(vendor.glob("*.md")))), "-P", HOST / "sdk/cmake/EmbedPages.cmake")
        self.run_it(compiler, "-std=c++20", *STRICT, f"-I{HOST}/sdk", f"-I{HOST}/abi", *LINK, *STATIC, "-o",
                    self.path / "acme.so", *sorted(vendor.glob("*.cpp")), pages)
        self.assertEqual([name for name in needed(self.path / "acme.so") if "++" in name or "gcc" in name], [])
        self.run_it(OPTIONS.isogloss, "validate", self.path / "acme.so", "--blocks", 100)
        program = self.path / "cycle.acme"
        program.write_text("G90 G54 G17 G21 G94 M171\nG0 X0. Y0. Z50.\nG98 G181 X10. Y10. Z-5. R2. F100\nG80 M172\nM30\n")
        run = (OPTIONS.isogloss, "run", program, "-d", "acme", "--plugins", self.path, "--dialects", vendor)
        blocks = [json.loads(line) for line in self.run_it(*run, "--emit", "blocks").stdout.splitlines()]
        self.assertEqual([b["AcmeVacuum"]["IsOn"] for b in blocks], [True, True, True, False, False])
        motions = self.run_it(*run, "--format", "csv").stdout
        self.assertEqual(re.findall(r",3,(\w+),10,10,(-?\d+),", motions),
                         [("rapid", "50"), ("rapid", "2"), ("feed", "-5"), ("feed", "2"), ("rapid", "50")])

    def version(self, contract):
        text = (contract / "isogloss.h").read_text()
        return ".".join(re.search(rf"IG_ABI_{part} (\d+)u", text)[1] for part in ("MAJOR", "MINOR"))

    def test_the_first_contract_is_what_it_was(self):
        sums = dict(reversed(line.split()) for line in (FIRST / "SHA256SUMS").read_text().splitlines())
        present = {str(f.relative_to(FIRST)) for f in FIRST.rglob("*") if f.suffix in (".h", ".hpp", ".cmake")}
        self.assertEqual(set(sums), present)
        for name, digest in sums.items():
            self.assertEqual(hashlib.sha256((FIRST / name).read_bytes()).hexdigest(), digest, name)
        self.assertEqual(self.version(FIRST), "1.0")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    for option in ("--isogloss", "--cc", "--cxx", "--cmake"):
        parser.add_argument(option, required=True)
    OPTIONS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
