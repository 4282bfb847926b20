#!/usr/bin/env python3
"""Latency of the language server: percentiles for each request on programs of 1,000, 10,000 and 100,000 lines.

The programs are those of tests/bench (workload mixed). Each sample changes a line and waits: for the diagnostics of the
changed text, or for the answer to a request about it, which includes the run of the changed text.
"""
import argparse
import json
import pathlib
import random
import statistics
import subprocess
import tempfile
import time

from lsp_client import Client, uri_of


def percentile(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))]


class Session:
    def __init__(self, options, path, seed):
        self.client = Client([options.isogloss, "lsp", *options.more], 120)
        self.client.initialize({"dialect": "iso"})
        self.uri, self.text = uri_of(path), path.read_text()
        self.lines = self.text.split("\n")
        self.version, self.random = 1, random.Random(seed)
        self.client.open(self.uri, self.text)
        self.client.diagnostics(self.uri, 1)

    def change(self):
        """Adds a comment to a line, or takes it away again; its number."""
        self.version += 1
        line = self.random.randrange(len(self.lines) // 2, len(self.lines) - 1)
        end = {"line": line, "character": len(self.lines[line])}
        self.lines[line] += " (x)"
        self.client.change(self.uri, self.version, {"range": {"start": end, "end": end}, "text": " (x)"})
        return line

    def diagnostics(self):
        self.change()
        self.client.diagnostics(self.uri, self.version)

    def ask(self, method, changed=True, **more):
        line = self.change() if changed else self.random.randrange(len(self.lines) - 1)
        document = {"textDocument": {"uri": self.uri}}
        if method in ("hover", "completion", "definition"):
            document["position"] = {"line": line, "character": 1}
        if method in ("inlayHint", "semanticTokens/range"):
            document["range"] = {"start": {"line": line, "character": 0}, "end": {"line": line + 50, "character": 0}}
        self.client.request("textDocument/" + method, {**document, **more})


def measure(options, path, lines):
    session = Session(options, path, lines)
    kinds = {"diagnostics after a change": session.diagnostics}
    for method in ("hover", "completion", "definition", "documentSymbol", "inlayHint", "semanticTokens/range", "foldingRange"):
        kinds[method + " after a change"] = lambda m=method: session.ask(m)
    for method in ("hover", "completion", "inlayHint"):
        kinds[method + ", text unchanged"] = lambda m=method: session.ask(m, changed=False)
    rows = {}
    for kind, call in kinds.items():
        call()
        times = []
        for _ in range(options.samples):
            begin = time.perf_counter()
            call()
            times.append((time.perf_counter() - begin) * 1000)
        rows[kind] = times
    session.client.kill()
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--isogloss", required=True)
    parser.add_argument("--workload", required=True, help="the program tests/bench/workload of a build")
    parser.add_argument("--samples", type=int, default=20)
    parser.add_argument("--lines", type=int, nargs="+", default=[1000, 10000, 100000])
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--more", nargs="*", default=[], help="further options of the server")
    options = parser.parse_args()
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        for lines in options.lines:
            path = pathlib.Path(folder, f"part{lines}.nc")
            subprocess.run([options.workload, "mixed", str(lines), "-o", str(path)], check=True)
            found[lines] = measure(options, path, lines)
    if options.json:
        print(json.dumps(found))
        return
    print("| request | " + " | ".join(f"{n:,} lines: 50 % / 90 % / 99 %" for n in found) + " |")
    print("|---|" + "---|" * len(found))
    for kind in next(iter(found.values())):
        cells = [f"{statistics.median(rows[kind]):.0f} / {percentile(rows[kind], .9):.0f} / {percentile(rows[kind], .99):.0f}"
                 for rows in found.values()]
        print(f"| {kind} | " + " | ".join(cells) + " |")


main()
