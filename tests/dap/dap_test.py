#!/usr/bin/env python3
"""`isogloss dap`: a client runs a written script of requests on programs of all dialects, and on broken ones.

  dap_test.py --isogloss PATH --source FOLDER [--seconds N] [unittest's own options]
"""
import argparse
import pathlib
import random
import sys
import tempfile
import time
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.path.insert(0, str(HERE.parent / "support"))

from dap_client import Client, Refused  # noqa: E402: it lies in another folder

OPTIONS = None

PART = """%
O0001 (PART)
G21 G17 G90 G94 G40 G49 G80
#101=5.
(ONLY A COMMENT)

T1 M06
G00 X0 Y0 Z50. S1000 M03
G98 G81 X10. Y10. Z-12. R2. F600
X20.
G80 M05
M98 P100 L2
#102=#101*2
G01 X#102 F300
M30
O0100
G91 G01 X1. F800
G90
M99
%
"""

SLOPE = """%
O0002
#100=10.
G00 X0 Y0
G41 D1 G01 X#100 Y0 F500
Y20.
#100=30.
X#100
Y40.
G40 X0 Y60.
G00 Z100.
M30
%
"""


class Sessions(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.clients = []

    def tearDown(self):
        for client in self.clients:
            self.assertEqual(client.close(), 0, client.errors)
            self.assertEqual(client.errors, "")

    def file(self, text, name="part.nc"):
        path = self.folder / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def client(self, *arguments):
        client = Client([OPTIONS.isogloss, "dap", *arguments], OPTIONS.seconds)
        self.clients.append(client)
        return client

    def start(self, text=PART, breakpoints=(), name="part.nc", **arguments):
        path = self.file(text, name)
        client = self.client()
        arguments.setdefault("dialect", "fanuc")
        self.answers = client.launch(path, {str(path): list(breakpoints)}, **arguments)
        return client


class Stepping(Sessions):
    def test_a_step_shows_the_block_that_comes_next_and_skips_comments(self):
        client = self.start(stopOnEntry=True)
        self.assertEqual(client.stop()["reason"], "entry")
        lines = [client.line()]
        while (line := client.step()) is not None:
            lines.append(line)
        self.assertEqual([n for n in lines if n > 2], [3, 4, 7, 8, 9, 10, 11, 12, 13, 14, 15])

    def test_steps_lead_into_a_called_program_with_its_passes_and_out_of_it(self):
        client = self.start(breakpoints=[12])
        self.assertEqual(client.stop()["reason"], "breakpoint")
        self.assertEqual(client.step("stepIn"), 16)
        names = [f["name"] for f in client.frames()]
        self.assertEqual(len(names), 2)
        self.assertIn("pass 1 of 2", names[0])
        self.assertEqual(client.frames()[1]["line"], 12)
        passes = set()
        while client.line() >= 16:
            passes.add(client.frames()[0]["name"])
            client.step()
        self.assertEqual(len(passes), 2)
        self.assertEqual(client.line(), 13)

    def test_a_step_out_ends_behind_all_passes_of_the_call(self):
        client = self.start(breakpoints=[17])
        client.stop()
        client.request("setBreakpoints", source={"path": str(self.folder / "part.nc")}, breakpoints=[])
        self.assertEqual(client.step("stepOut"), 13)

    def test_a_step_leads_into_the_strokes_of_a_cycle(self):
        client = self.start(breakpoints=[9])
        client.stop()
        names, depths = [], []
        self.assertEqual(client.step("stepIn"), 9)
        while client.line() == 9:
            names.append(client.frames()[0]["name"])
            depths.append(client.values("Positions")["Z"])
            client.step("stepIn")
        self.assertEqual(len(names), 4, names)
        self.assertTrue(names[0].startswith("stroke 1 of 4: rapid to X10 Y10"), names)
        self.assertTrue(names[2].startswith("stroke 3 of 4: feed to Z-12 at 600 mm/min"), names)
        self.assertEqual(depths, ["50 mm", "50 mm", "2 mm", "-12 mm"])
        self.assertEqual(client.line(), 10)

    def test_a_step_out_of_strokes_comes_to_the_next_block(self):
        client = self.start(breakpoints=[9])
        client.stop()
        client.step("stepIn")
        self.assertEqual(client.step("stepOut"), 10)

    def test_steps_go_back_over_calls(self):
        client = self.start(breakpoints=[14])
        client.stop()
        self.assertEqual(client.step("stepBack"), 13)
        self.assertEqual(client.value("#102"), "no value")
        self.assertEqual(client.step("stepBack"), 12)
        self.assertEqual(client.step("stepBack"), 11)
        self.assertEqual(client.step(), 12)

    def test_reverse_continue_comes_to_the_last_breakpoint_before(self):
        client = self.start(breakpoints=[8, 10, 14])
        self.assertEqual([client.stop() and client.line(), client.step("continue"), client.step("continue")],
                         [8, 10, 14])
        self.assertEqual(client.step("reverseContinue"), 10)
        self.assertEqual(client.step("reverseContinue"), 8)
        client.request("reverseContinue", threadId=1)
        self.assertEqual(client.stop()["reason"], "entry")

    def test_a_run_that_does_not_end_is_paused(self):
        client = self.start("%\nO1\nN1 #1=#1+1\nGOTO 1\nM30\n%\n", maxJumps=10**12)
        time.sleep(0.3)
        client.request("pause", threadId=1)
        self.assertEqual(client.stop()["reason"], "pause")
        self.assertIn(client.line(), (3, 4))
        self.assertGreater(float(client.value("#1")), 0)

    def test_restart_reads_the_program_again(self):
        client = self.start(breakpoints=[4])
        client.stop()
        self.file(PART.replace("#101=5.", "#101=7."))
        client.request("restart")
        client.stop()
        client.step()
        self.assertEqual(client.value("#101"), "7")

    def test_stop_at_end_stands_behind_the_last_block(self):
        client = self.start(stopAtEnd=True)
        self.assertEqual(client.stop()["description"], "the program has ended")
        self.assertEqual(client.line(), 15)
        self.assertEqual(client.step("stepBack"), 15)
        self.assertEqual(client.step("stepBack"), 14)


class Breakpoints(Sessions):
    def test_lines_without_a_block_are_not_verified(self):
        client = self.start(breakpoints=[5, 6, 7, 500])
        answers = next(iter(self.answers.values()))
        self.assertEqual([a["verified"] for a in answers], [False, False, True, False])
        self.assertIn("line 5", answers[0]["message"])
        client.stop()
        self.assertEqual(client.line(), 7)

    def test_a_line_of_a_joined_block_moves_to_its_beginning(self):
        text = ("BEGIN PGM A MM\nCYCL DEF 200 DRILLING ~\nQ200=2 ~\nQ201=-10 ~\nQ206=200 ~\nQ202=5 ~\nQ210=0 ~\n"
                "Q203=0 ~\nQ204=50 ~\nQ211=0\nL X10 Y10 R0 FMAX M99\nEND PGM A MM\n")
        client = self.start(text, [4], "a.h", dialect="heidenhain")
        answer = next(iter(self.answers.values()))[0]
        self.assertEqual((answer["verified"], answer["line"]), (True, 2))
        client.stop()
        self.assertEqual(client.line(), 2)

    def test_conditions_hit_counts_and_log_points(self):
        client = self.start(breakpoints=[{"line": 17, "condition": "pass == 2"},
                                         {"line": 16, "hitCondition": "2"},
                                         {"line": 13, "logMessage": "X is {X} and #101 {#101} {{}}"}])
        client.stop()
        self.assertEqual((client.line(), client.value("pass")), (16, "2"))
        self.assertEqual((client.step("continue"), client.value("pass")), (17, "2"))
        self.assertIsNone(client.step("continue"))
        self.assertIn("X is 22 and #101 5 {}\n", [o["output"] for o in client.outputs])

    def test_a_faulty_condition_is_refused_with_its_reason(self):
        self.start(breakpoints=[{"line": 9, "condition": "feeed > 3"}, {"line": 9, "condition": "X >"},
                                {"line": 9, "hitCondition": "often"}, {"line": 9, "logMessage": "{X"}])
        messages = [a["message"] for a in next(iter(self.answers.values()))]
        self.assertIn("did you mean feed?", messages[0])
        self.assertIn("ends where a value is missing", messages[1])
        self.assertIn("hit count", messages[2])
        self.assertIn("not closed", messages[3])

    def test_a_condition_stops_the_stroke_of_the_cycle_that_fulfils_it(self):
        client = self.start(logic=["Z < -10", "spindle off and line > 9", "feed > 700"])
        stop = client.stop()
        self.assertEqual((stop["reason"], stop["description"]), ("function breakpoint", "Z < -10 became true"))
        self.assertEqual((client.line(), client.values("Positions")["Z"]), (9, "-12 mm"))
        self.assertEqual(client.step("continue"), 10)
        self.assertEqual(client.step("continue"), 11)
        self.assertEqual(client.value("spindle"), "STOP")
        self.assertEqual((client.step("continue"), client.value("feed")), (17, "800"))

    def test_breakpoints_in_files_of_called_programs(self):
        called = self.file("O0200\nG01 Y5.\nM99\n", "O0200.nc")
        path = self.file("O1\nG90 G94 G01 F100 X1.\nM98 P200\nM30\n")
        client = self.client()
        client.launch(path, {str(called): [2]}, dialect="fanuc")
        client.stop()
        frames = client.frames()
        self.assertEqual([(pathlib.Path(f["source"]["path"]).name, f["line"]) for f in frames],
                         [("O0200.nc", 2), ("part.nc", 3)])

    def test_errors_stop_the_run_behind_their_block(self):
        client = self.start("O1\nG90 G94 G01 X1. F100\nM98 P777\nX2.\nM30\n", filters=["error"])
        self.assertEqual(client.stop()["reason"], "exception")
        self.assertEqual(client.line(), 3)
        info = client.request("exceptionInfo", threadId=1)
        self.assertRegex(info["exceptionId"], r"^[A-Z]+-\d+$")
        self.assertIn("777", info["description"])
        self.assertEqual(client.step(), 4)

    def test_breakpoints_are_changed_while_the_program_runs(self):
        client = self.start("%\nO1\nN1 #1=#1+1\nGOTO 1\nM30\n%\n", maxJumps=10**12)
        path = str(self.folder / "part.nc")
        client.request("setBreakpoints", source={"path": path}, breakpoints=[{"line": 4}])
        self.assertEqual(client.stop()["reason"], "breakpoint")
        self.assertEqual(client.line(), 4)

    def test_locations_of_breakpoints_are_the_lines_of_blocks(self):
        client = self.start(breakpoints=[4])
        client.stop()
        found = client.request("breakpointLocations", source={"path": str(self.folder / "part.nc")}, line=4, endLine=8)
        self.assertEqual([b["line"] for b in found["breakpoints"]], [4, 7, 8])


class State(Sessions):
    def test_scopes_show_positions_modal_state_block_and_tables(self):
        client = self.start(breakpoints=[10])
        client.stop()
        self.assertEqual(client.values("Positions")["X"], "10 mm")
        modal = client.variables(client.scope("Modal state"))
        feed = client.variables(modal["Feedrate"]["variablesReference"])
        self.assertEqual(feed["FeedrateValue"]["value"], "600")
        self.assertEqual(feed["FeedrateValue"]["evaluateName"], "Feedrate.FeedrateValue")
        self.assertTrue(feed["FeedrateValue"]["type"])
        block = client.variables(client.scope("Block before"))
        self.assertEqual(block["text"]["value"], "G98 G81 X10. Y10. Z-12. R2. F600")
        words = {n: v["value"] for n, v in client.variables(block["words"]["variablesReference"]).items()}
        self.assertEqual({n: words[n] for n in ("G81", "Z-12.", "F600")}, {"G81": "G81", "Z-12.": "-12", "F600": "600"})
        self.assertEqual(len(client.variables(block["motions"]["variablesReference"])), 4)
        self.assertTrue(client.variables(client.scope("Tables")))

    def test_a_variable_is_set_and_the_run_goes_on_with_it(self):
        client = self.start(breakpoints=[13])
        client.stop()
        scope = client.scope("Variables")
        answer = client.request("setVariable", variablesReference=scope, name="#101", value="8.5")
        self.assertEqual(answer["value"], "8.5")
        self.assertEqual(client.step(), 14)
        self.assertEqual(client.value("#102"), "17")
        self.assertEqual(client.step(), 15)
        self.assertEqual(client.values("Positions")["X"], "17 mm")

    def test_an_edit_is_made_again_where_the_run_comes_to_its_block(self):
        client = self.start(breakpoints=[13])
        client.stop()
        client.request("setExpression", expression='var("#101")', value="8")
        self.assertEqual(client.step("stepBack"), 12)
        self.assertEqual(client.value("#101"), "5")
        self.assertEqual(client.step(), 13)
        self.assertEqual(client.value("#101"), "8")

    def test_an_edit_drops_the_edits_behind_it(self):
        client = self.start(breakpoints=[13])
        client.stop()
        client.request("setExpression", expression="#101", value="8")
        client.step("stepBack")
        client.request("setExpression", expression="#101", value="6")
        self.assertEqual((client.step(), client.value("#101")), (13, "6"))

    def test_what_cannot_be_set_is_refused(self):
        client = self.start(breakpoints=[13])
        client.stop()
        scope = client.scope("Variables")
        for name, value in (("#101", "M30"), ("#101", "5\nM30"), ("#999", "1"), ("#101", "nan"), ("#101", "")):
            with self.assertRaises(Refused):
                client.request("setVariable", variablesReference=scope, name=name, value=value)
        with self.assertRaises(Refused):
            client.request("setVariable", variablesReference=client.scope("Positions"), name="X", value="1")
        self.assertEqual(client.value("#101"), "5")

    def test_under_radius_compensation_a_block_is_shown_when_it_is_finished(self):
        client = self.start(SLOPE, stopOnEntry=True)
        client.stop()
        seen = []
        while (line := client.step()) is not None:
            seen.append((line, client.value("#100")))
        values = dict(seen)
        self.assertEqual(values[6], "10")
        self.assertEqual(values[7], "10", "the run has read line 7 ahead, and the debugger has not")
        self.assertEqual(values[8], "30")
        self.assertEqual([n for n, _ in seen], sorted(n for n, _ in seen))

    def test_an_edit_under_radius_compensation_takes_effect_at_the_block_that_is_shown(self):
        client = self.start(SLOPE, [8])
        client.stop()
        client.request("setExpression", expression="#100", value="33")
        self.assertEqual((client.line(), client.value("#100")), (8, "33"))
        client.step()
        self.assertEqual(client.values("Positions")["X"], "33 mm")

    def test_local_variables_belong_to_their_call(self):
        client = self.start("O1\n#1=3.\nG65 P300 A7.\n#2=#1\nM30\nO300\n#3=#1+1.\nM99\n", [8])
        client.stop()
        self.assertEqual(client.values("Variables")["#1"], "7")
        self.assertEqual(client.values("Variables", frame=1)["#1"], "3")
        self.assertEqual(client.value("#3"), "8")

    def test_expressions(self):
        client = self.start(breakpoints=[10])
        client.stop()
        for expression, value in (("X + 2 * 3", "16"), ("spindle on", "true"), ("spindle is cw", "true"),
                                  ("not (Z < -10)", "true"), ("#101 * 2 = 10", "true"), ("tool == 1", "true"),
                                  ("Feedrate.Unit == \"MM/MIN\"", "true"), ("has(#777)", "false"),
                                  ("#777 > 1", "false"), ("max(X, 11) - abs(-1)", "10"), ("1 / 0", "no value"),
                                  ("machine.X", "10"), ("line", "10"), ("coolant off", "true"), ("depth", "0")):
            with self.subTest(expression):
                self.assertEqual(client.value(expression), value)
        for broken in ("", "(", "X +", "foo", "Feedrate.Unitt", "1 2", "var(3)", "((((" * 100, "X" * 5000, "\x00", "é"):
            with self.subTest(broken[:20]), self.assertRaises(Refused):
                client.value(broken)


SCRIPT = ("next", "stepIn", "stepIn", "next", "stepBack", "stepOut", "continue", "reverseContinue", "next")


class RealPrograms(Sessions):
    """The same script on golden programs of all dialects: every request has an answer or an error."""

    def run_script(self, path, dialect):
        client = self.client()
        lines = list(range(1, 200, 7))
        try:
            client.launch(path, {str(path): lines}, logic=["Z < -1", "spindle off"], filters=["error"],
                          dialect=dialect, stopOnEntry=True, maxJumps=20_000, maxBlocks=200_000)
        except Refused as refused:
            return str(refused)
        for command in SCRIPT:
            if client.stop() is None:
                break
            self.look_around(client)
            client.request(command, threadId=1)
        return ""

    def look_around(self, client):
        for frame in client.request("stackTrace", threadId=1)["stackFrames"]:
            for scope in client.request("scopes", frameId=frame["id"])["scopes"]:
                for variable in client.request("variables",
                                               variablesReference=scope["variablesReference"])["variables"]:
                    if variable["variablesReference"]:
                        client.request("variables", variablesReference=variable["variablesReference"])
        client.value("Z + 1")

    def test_golden_programs_of_all_dialects(self):
        programs = OPTIONS.source / "tests/programs"
        chosen = random.Random(21)
        count = 0
        for folder in sorted(p for p in programs.iterdir() if p.is_dir()):
            dialect = folder.name if (OPTIONS.source / f"dialects/{folder.name}.xml").exists() else None
            files = [f for f in sorted(folder.rglob("*")) if f.suffix.lower() in
                     (".nc", ".mpf", ".h", ".ngc", ".min", ".eia", ".tap")]
            for path in chosen.sample(files, min(OPTIONS.programs, len(files))):
                with self.subTest(path.name):
                    said = self.run_script(path, dialect or "")
                    self.assertEqual(said, "", path)
                    count += 1
                    self.assertEqual(self.clients.pop().close(), 0)
        self.assertGreater(count, 6)

    def test_broken_programs(self):
        texts = {"empty": b"", "blank": b"\n\n \n", "binary": bytes(range(256)) * 40, "cut": PART.encode()[:97],
                 "utf16": "O1\nG0 X1\n".encode("utf-16"), "long": b"G1 " + b"X1 " * 40000 + b"\n",
                 "no end": b"G91 G1 X1. F9\n" * 50, "deep": b"O1\nM98 P1\n", "brackets": b"#1=" + b"[" * 3000 + b"\n"}
        for name, text in texts.items():
            for dialect in ("fanuc", "siemens", "heidenhain"):
                with self.subTest(f"{name} {dialect}"):
                    self.run_script(self.file(text, f"{name}.nc"), dialect)
                    self.assertEqual(self.clients.pop().close(), 0)


class Protocol(Sessions):
    REQUESTS = ("initialize launch attach configurationDone restart terminate setBreakpoints setFunctionBreakpoints "
                "setExceptionBreakpoints breakpointLocations threads stackTrace scopes variables setVariable "
                "setExpression evaluate exceptionInfo loadedSources source continue next stepIn stepOut stepBack "
                "reverseContinue pause cancel nonsense").split()

    def test_every_request_is_answered_before_a_launch_and_with_wrong_arguments(self):
        wrong = (None, {}, [], 7, "text", {"threadId": "x"}, {"source": 3, "breakpoints": {}}, {"program": 5},
                 {"source": {"path": "/none"}, "breakpoints": [3, {"line": -4}, {"line": 1e300}]},
                 {"variablesReference": -1, "frameId": 10**15, "name": [], "value": {}}, {"expression": None},
                 {"breakpoints": [{"name": 3}, 5]}, {"filters": ["x", 4]})
        client = self.client()
        for arguments in wrong:
            for request in self.REQUESTS:
                response = client.answer(client.send(request, arguments))
                self.assertEqual(response["command"], request)
                if not response["success"]:
                    self.assertTrue(response["message"])

    def test_every_request_is_answered_while_the_program_runs_and_stands(self):
        client = self.start("%\nO1\nN1 #1=#1+1\nGOTO 1\nM30\n%\n", maxJumps=10**12)
        quiet = [r for r in self.REQUESTS if r not in ("restart", "terminate", "pause")]
        for request in quiet:
            client.answer(client.send(request, {}))
        client.request("pause", threadId=1)
        client.stop()
        for request in quiet:
            client.answer(client.send(request, {"frameId": 1, "variablesReference": 1, "expression": "X"}))

    def test_a_launch_that_cannot_be_made_says_why(self):
        part = self.file(PART)
        for arguments, said in (({"program": str(self.folder / "none.nc")}, "none.nc"),
                                ({"program": str(self.folder)}, "folder"),
                                ({"program": str(part), "dialect": "fanuk"}, "fanuc"),
                                ({"program": str(part), "machine": "nowhere"}, "nowhere"),
                                ({"program": str(part), "dialect": "fanuc", "set": ["x"]}, "NAME=VALUE"),
                                ({"program": str(part), "onError": "perhaps"}, "onError"),
                                ({}, "program")):
            client = self.client()
            client.request("initialize", adapterID="x")
            with self.subTest(said), self.assertRaises(Refused) as refused:
                client.request("launch", **arguments)
            self.assertIn(said, str(refused.exception))

    def test_broken_frames_end_in_a_message_or_the_end(self):
        for data in (b"Content-Length: 3\r\n\r\n{x}", b"Content-Length: 2\r\n\r\n[]", b"Content-Length: 4\r\n\r\nnull",
                     b'Content-Length: 17\r\n\r\n{"type":"request"'):
            client = self.client()
            client.send_bytes(data)
            self.assertIn("supportsStepBack",
                          client.request("initialize", adapterID="x"))
        broken = Client([OPTIONS.isogloss, "dap"], OPTIONS.seconds)
        broken.send_bytes(b"G1 X1\n\n")
        self.assertEqual(broken.close(), 1)

    def test_the_stream_may_end_at_any_time(self):
        for standing in (False, True):
            client = self.start(stopOnEntry=standing)
            client.stop()
            client.process.stdin.close()
            self.assertEqual(client.process.wait(OPTIONS.seconds), 0)

    def test_terminate_and_disconnect_end_a_run_that_does_not_end(self):
        client = self.start("%\nO1\nN1 #1=#1+1\nGOTO 1\nM30\n%\n", maxJumps=10**12)
        client.request("terminate")
        client.event("terminated")

    def test_lines_may_count_from_zero(self):
        path = self.file(PART)
        client = self.client()
        client.request("initialize", adapterID="x", linesStartAt1=False, columnsStartAt1=False)
        client.request("launch", program=str(path), dialect="fanuc")
        client.event("initialized")
        answer = client.request("setBreakpoints", source={"path": str(path)}, breakpoints=[{"line": 8}])
        self.assertEqual(answer["breakpoints"][0]["line"], 8)
        client.request("configurationDone")
        client.stop()
        self.assertEqual((client.line(), client.value("line")), (8, "9"))

    def test_diagnostics_come_as_output_with_their_place(self):
        client = self.start("O1\nG90 G94 G01 X1. F100 E7\nM30\n")
        client.event("exited")
        client.event("terminated")
        said = [o for o in client.outputs if "nothing in this block uses E7" in o["output"]]
        self.assertEqual((len(said), said[0]["line"], said[0]["category"]), (1, 2, "console"))

    def test_a_flood_of_diagnostics_is_cut(self):
        client = self.start("O1\nG90 G94 G01 F100\n" + "X1. E7\n" * 5000 + "M30\n")
        client.event("terminated")
        said = [o["output"] for o in client.outputs]
        self.assertLess(len(said), 130)
        self.assertTrue(any("4900 further diagnostics" in text for text in said), said[-3:])


def main():
    global OPTIONS
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True)
    parser.add_argument("--source", type=pathlib.Path, default=HERE.parent.parent)
    parser.add_argument("--seconds", type=float, default=30, help="limit of each wait")
    parser.add_argument("--programs", type=int, default=2, help="golden programs of each dialect")
    OPTIONS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])


if __name__ == "__main__":
    main()
