#!/usr/bin/env python3
"""How long a client of `isogloss dap` waits: percentiles at programs of 1,000, 10,000 and 100,000 lines.

  latency.py --isogloss PATH [--lines N…]

The cost of continuing is the time from the request to the stop at the last line, over that of the same way without a
breakpoint before it; both hold the start of the run, and `run --emit none` is shown beside them.
"""
import argparse
import pathlib
import subprocess
import tempfile
import time

from dap_client import Client


def program(lines):
    out = ["%", "O1", "G21 G17 G90 G94 G54", "#100=0.", "G00 X0 Y0 Z50. S1000 M03"]
    for n in range(lines - 7):
        out.append("#100=#100+1." if n % 20 == 19 else f"G01 X{n % 97}.{n % 10} Y{n % 89}. Z-{n % 5}.5 F{500 + n % 7}")
    return "\n".join([*out, "M30", "%", ""])


def timed(work):
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def row(what, seconds):
    ordered = sorted(seconds)
    at = lambda share: ordered[min(int(len(ordered) * share), len(ordered) - 1)] * 1000  # noqa: E731
    print(f"  {what:<34} {at(0.5):9.2f} {at(0.95):9.2f} {at(0.99):9.2f} {ordered[-1] * 1000:9.2f}")


class Session:
    def __init__(self, options, path, breakpoints, **more):
        self.client = Client([options.isogloss, "dap"], 120)
        self.launch = timed(lambda: self.client.launch(path, {str(path): breakpoints}, dialect="fanuc", **more))

    def move(self, command):
        def work():
            self.client.request(command, threadId=1)
            self.client.stop()
        return timed(work)

    def state(self):
        def work():
            frame = self.client.frames()[0]["id"]
            for scope in self.client.request("scopes", frameId=frame)["scopes"]:
                self.client.request("variables", variablesReference=scope["variablesReference"])
        return timed(work)


def measure(options, lines, folder):
    path = pathlib.Path(folder) / f"part{lines}.nc"
    path.write_text(program(lines))
    print(f"{lines} lines{'':<24} median      95 %      99 %       max  (ms)")
    session = Session(options, path, [lines - 1], stopOnEntry=True)
    session.client.stop()
    session.move("stepIn")
    steps = [(session.move("next"), session.state()) for _ in range(200)]
    row("step, to the stop", [s for s, _ in steps])
    row("stack, scopes and their variables", [s for _, s in steps])
    last = session.move("continue")
    row("continue to the last line", [last])
    row("step back from there", [session.move("stepBack") for _ in range(3)])
    row("set a variable there", [timed(lambda: session.client.request(
        "setExpression", expression="#100", value="1"))])
    row("reverse to the start", [session.move("reverseContinue")])
    session.client.close()
    for what, breakpoints, logic in (("nothing", [], ()), ("a breakpoint at the end", [lines - 1], ()),
                                     ("a condition", [], ("Z < -1000",))):
        times = []
        for _ in range(3):
            client = Client([options.isogloss, "dap"], 120)
            client.request("initialize", adapterID="x")
            client.request("launch", program=str(path), dialect="fanuc")
            client.request("setBreakpoints", source={"path": str(path)},
                           breakpoints=[{"line": n} for n in breakpoints])
            client.request("setFunctionBreakpoints", breakpoints=[{"name": n} for n in logic])
            begin = time.perf_counter()
            client.request("configurationDone")
            client.stop()
            times.append(time.perf_counter() - begin)
            client.close()
        row(f"whole run with {what}", times)
    row("isogloss run --emit none", [timed(lambda: subprocess.run(
        [options.isogloss, "run", str(path), "-d", "fanuc", "--emit", "none"], check=True, capture_output=True))
        for _ in range(3)])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True)
    parser.add_argument("--lines", type=int, nargs="*", default=[1_000, 10_000, 100_000])
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for lines in options.lines:
            measure(options, lines, folder)


if __name__ == "__main__":
    main()
