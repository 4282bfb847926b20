#!/usr/bin/env python3
"""Are the workloads what they claim to be: N blocks, the same for the same seed, clean for a Fanuc and for LinuxCNC?"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

BLOCKS = 5000
CYCLES = "G81,G81,G82,G83,G83,G73,G85"


def workload(tools, *arguments):
    return subprocess.run([tools / "workload", *arguments], check=True, capture_output=True).stdout


def linuxcnc_refuses(folder, program):
    (folder / "fresh.var").write_text("")
    (folder / "tool.tbl").write_text("".join(f"T{t} P{t} Z{t}.5 D0.2 ;\n" for t in range(1, 21)))
    out = folder / "out.canon"
    subprocess.run(["rs274", "-t", "tool.tbl", "-v", "fresh.var", "-g", program, out], cwd=folder, check=False,
                   env={**os.environ, "HOME": str(folder)}, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return "PROGRAM_END" not in out.read_text()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tools", type=pathlib.Path, required=True)
    parser.add_argument("--isogloss", type=pathlib.Path, required=True)
    options = parser.parse_args()
    failures = []

    def check(holds, what):
        if not holds:
            failures.append(what)

    with tempfile.TemporaryDirectory(prefix="isogloss-workload-") as name:
        folder = pathlib.Path(name)
        for kind in ("surface", "mixed", "drilling"):
            for seed in ("1", "7"):
                like_this = (options.tools, kind, str(BLOCKS), "--cycles", CYCLES, "--seed", seed)
                text = workload(*like_this)
                check(text.count(b"\n") == BLOCKS, f"{kind} {seed}: not {BLOCKS} blocks")
                check(text == workload(*like_this), f"{kind} {seed}: not repeatable")
                for_linuxcnc = workload(*like_this, "--repeat", "L")
                check(for_linuxcnc.replace(b" L", b" K").replace(b"G10 K2", b"G10 L2") == text,
                      f"{kind} {seed}: more than the letter of repeats differs")
                path = folder / f"{kind}{seed}.nc"
                path.write_bytes(text)
                counted = subprocess.run([options.tools / "tokenizer", path], check=True, capture_output=True,
                                         text=True)
                check(counted.stdout.startswith(f"blocks {BLOCKS} "), f"{kind} {seed}: tokenizer says {counted.stdout}")
                run = subprocess.run([options.isogloss, "run", path, "-d", "fanuc", "--emit", "none"],
                                     capture_output=True, text=True, check=False)
                check(run.returncode == 0, f"{kind} {seed}: isogloss ends with {run.returncode}\n{run.stderr[:1500]}")
                if shutil.which("rs274"):
                    path.write_bytes(for_linuxcnc)
                    check(not linuxcnc_refuses(folder, path), f"{kind} {seed}: LinuxCNC refuses it")
            one, two = (workload(options.tools, kind, "500", "--seed", seed) for seed in ("1", "2"))
            check(one != two, f"{kind}: the seed changes nothing")
        text = workload(options.tools, "five-axis", str(BLOCKS))
        check(text.count(b"\n") == BLOCKS, f"five-axis: not {BLOCKS} blocks")
        check(text == workload(options.tools, "five-axis", str(BLOCKS)), "five-axis: not repeatable")
        path = folder / "five-axis.nc"
        path.write_bytes(text)
        run = subprocess.run([options.isogloss, "run", path, "-d", "fanuc", "--emit", "none", "--machine",
                              pathlib.Path(__file__).with_name("five_axis.xml")], capture_output=True, text=True,
                             check=False)
        check(run.returncode == 0, f"five-axis: isogloss ends with {run.returncode}\n{run.stderr[:1500]}")
    for failure in failures:
        print(failure)
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
