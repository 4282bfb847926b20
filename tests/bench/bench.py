#!/usr/bin/env python3
"""Measures `isogloss run` against a bare tokenizer and, where it is installed, LinuxCNC's rs274.

  bench.py [--build DIR] [--blocks N] [--large N] [--runs R] [--kinds surface,mixed,drilling,five-axis] [--no-large]
           [--cycles G81,G83]

All commands run in turn, R rounds after one to warm up; medians are printed. Figures are whole processes, start-up
included; costs and ratios are of wall time, which a user waits for: a long program is scanned and written on processors
that are free. Processor time of all threads stands beside. The workloads are the same bytes for everyone, except for the letter of repeats (K, for LinuxCNC L).
"""
import argparse
import json
import os
import pathlib
import platform
import shutil
import statistics
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
KINDS = ("surface", "mixed", "drilling", "five-axis")
CYCLES = "G81,G81,G82,G83,G83,G73,G85"  # those that both controls have, as often as programs use them


class Bench:
    def __init__(self, build, folder, cycles):
        self.cycles = cycles
        self.folder = folder
        self.tool = lambda name: str(build / "tests" / "bench" / name)
        self.isogloss = str(build / "isogloss")
        self.rs274 = shutil.which("rs274")
        self.tools_xml = folder / "tools.xml"
        rows = "".join(f'  <Tool id="{t}" H="{100 + 2.5 * t}"/>\n' for t in range(1, 21))
        self.tools_xml.write_text(f"<ToolOffsetTable>\n{rows}</ToolOffsetTable>\n")
        self.tool_table = folder / "tool.tbl"
        self.tool_table.write_text("".join(f"T{t} P{t} Z{(100 + 2.5 * t) / 25.4:.6f} D0.2 ;\n" for t in range(1, 21)))

    def workload(self, kind, blocks):
        for repeat in "KL":
            path = self.folder / f"{kind}-{blocks}-{repeat}.nc"
            if not path.exists():
                subprocess.run([self.tool("workload"), kind, str(blocks), "--cycles", self.cycles, "--repeat",
                                repeat, "-o", path], check=True)
        return self.folder / f"{kind}-{blocks}-K.nc", self.folder / f"{kind}-{blocks}-L.nc"

    def contenders(self, fanuc, linuxcnc):
        run = [self.isogloss, "run", str(fanuc), "-d", "fanuc", "--tools", str(self.tools_xml)]
        is_five_axis = fanuc.name.startswith("five-axis")
        if is_five_axis:
            run += ["--machine", str(HERE / "five_axis.xml")]
        commands = {
            "tokenizer": [self.tool("tokenizer"), str(fanuc)],
            "isogloss none": run + ["--emit", "none"],
            "isogloss csv": run + ["--emit", "motions", "--format", "csv", "-o", "/dev/null"],
            "isogloss binary": run + ["--emit", "motions", "--format", "binary", "-o", "/dev/null"],
            "isogloss jsonl": run + ["--emit", "motions", "--format", "jsonl", "-o", "/dev/null"],
        }
        if self.rs274 and not is_five_axis:
            commands["rs274"] = [self.rs274, "-t", str(self.tool_table), "-v", str(self.folder / "fresh.var"), "-g",
                                 str(linuxcnc), "/dev/null"]
        return commands

    def once(self, command):
        (self.folder / "fresh.var").write_text("")
        result = self.folder / "result"
        log = self.folder / "stderr"
        with open(log, "w") as err:
            subprocess.run([self.tool("measure"), result, *command], stdout=subprocess.DEVNULL, stderr=err, check=True,
                           env={**os.environ, "HOME": str(self.folder)})  # rs274 keeps its tools there
        seconds, busy, kib, status = result.read_text().split()
        if int(status) != 0:
            sys.exit(f"exit status {status}: {' '.join(command)}\n{log.read_text()[:2000]}")
        return float(seconds), float(busy), int(kib)

    def rounds(self, commands, runs):
        samples = {key: [] for key in commands}
        for number in range(runs + 1):
            for key, command in commands.items():
                sample = self.once(command)
                if number > 0:
                    samples[key].append(sample)
        return {key: (statistics.median(s for s, _, _ in all_), statistics.median(b for _, b, _ in all_),
                      max(k for _, _, k in all_)) for key, all_ in samples.items()}


def table(title, header, rows):
    widths = [max(len(str(r[i])) for r in [header, *rows]) for i in range(len(header))]
    line = lambda cells: "| " + " | ".join(str(c).ljust(w) for c, w in zip(cells, widths)) + " |"
    print(f"\n{title}\n\n{line(header)}\n|{'|'.join('-' * (w + 2) for w in widths)}|")
    for row in rows:
        print(line(row))
    sys.stdout.flush()


def ratio(value):
    return f"{value:.2f}" if value < 10 else f"{value:.1f}"


def cost_rows(kinds, measured, blocks):
    rows = []
    for kind in kinds:
        floor = measured[kind]["tokenizer"][0]
        peer = measured[kind].get("rs274", (None, None))[0]
        for name, (seconds, busy, kib) in measured[kind].items():
            rows.append([kind, name, f"{1e3 * seconds:.1f}", f"{1e3 * busy:.1f}", f"{1e9 * seconds / blocks:.0f}",
                         f"{blocks / seconds / 1e6:.2f}", ratio(seconds / floor), ratio(peer / seconds) if peer else "-",
                         f"{kib / 1024:.1f}"])
    return rows


COST_HEADER = ["workload", "command", "wall ms", "cpu ms", "ns/block", "M blocks/s", "x tokenizer",
               "faster than rs274", "peak MiB"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build")
    parser.add_argument("--blocks", type=int, default=100_000)
    parser.add_argument("--large", type=int, default=1_000_000)
    parser.add_argument("--no-large", action="store_true", help="leave the growth out")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--kinds", default=",".join(KINDS))
    parser.add_argument("--cycles", default=CYCLES, help="of the drilling workload")
    parser.add_argument("--json", type=pathlib.Path, help="write the figures there too")
    options = parser.parse_args()
    kinds = options.kinds.split(",")
    if not (options.build / "isogloss").exists():
        sys.exit(f"no isogloss in {options.build}: build first")

    with tempfile.TemporaryDirectory(prefix="isogloss-bench-") as name:
        bench = Bench(options.build.resolve(), pathlib.Path(name), options.cycles)
        print(f"{platform.machine()}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}; "
              f"median of {options.runs} interleaved runs" + ("" if bench.rs274 else "; rs274 is not installed"))
        figures = {}
        small = {k: bench.rounds(bench.contenders(*bench.workload(k, options.blocks)), options.runs) for k in kinds}
        figures[options.blocks] = small
        table(f"{options.blocks:,} blocks", COST_HEADER, cost_rows(kinds, small, options.blocks))

        if not options.no_large:
            large = {k: bench.rounds(bench.contenders(*bench.workload(k, options.large)), max(options.runs // 2, 1))
                     for k in kinds}
            figures[options.large] = large
            table(f"{options.large:,} blocks", COST_HEADER, cost_rows(kinds, large, options.large))
            table(f"Growth, {options.blocks:,} to {options.large:,} blocks",
                  ["workload", "command", "ns/block", "peak MiB"],
                  [[k, c, f"{1e9 * small[k][c][0] / options.blocks:.0f} -> {1e9 * large[k][c][0] / options.large:.0f}",
                    f"{small[k][c][2] / 1024:.1f} -> {large[k][c][2] / 1024:.1f}"] for k in kinds for c in small[k]])

        single = bench.folder / "single.nc"
        single.write_text("M30\n")
        start = bench.rounds(bench.contenders(single, single), 4 * options.runs)
        figures[1] = {"start-up": start}
        table("Start-up, one block", ["command", "wall ms", "cpu ms", "peak MiB"],
              [[c, f"{1e3 * s:.2f}", f"{1e3 * b:.2f}", f"{k / 1024:.1f}"] for c, (s, b, k) in start.items()])
        if options.json:
            options.json.write_text(json.dumps(figures, indent=1) + "\n")


if __name__ == "__main__":
    main()
