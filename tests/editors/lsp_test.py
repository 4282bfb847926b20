#!/usr/bin/env python3
"""The language server answers a written script of requests on programs of all brands, and on broken ones."""
import argparse
import json
import os
import pathlib
import random
import subprocess
import tempfile
import unittest

from lsp_client import Client, Failed, applied, frame, place, uri_of

options = None

FANUC = """%
O0001 (HOLES)
G21 G17 G90 G54
T1 M06
G43 H1 Z50. S1000 M03
#101=50.
G98 G81 X#101 Y30. Z-10. R2. F600 E7
X60.
Y40.
G80
N10 #102=0
WHILE [#102 LT 3] DO1
#102=#102+1
G1 X[#101+#102] F300
END1
IF [#102 EQ 9] GOTO 10
M98 P100
M05
M30
O0100
G1 X1. F100
M99
%
"""

SIEMENS = """; %_N_PART_MPF
N10 G90 G54 G17
R1=5 R2=0
START:
R2=R2+1
G1 X=R1*R2 F500
IF R2<3 GOTOB START
GOTOF ENDE
G1 X99
ENDE:
M30
"""

KLARTEXT = """0 BEGIN PGM TEST MM
1 TOOL CALL 5 Z S2000
2 Q1 = 10
3 LBL 1
4 L X+Q1 Y+20 FMAX
5 Q1 = Q1 + 5
6 LBL 0
7 CALL LBL 1 REP 2
8 L Z-5 F300 M3
9 M30
10 END PGM TEST MM
"""


class Script(unittest.TestCase):
    def client(self, settings=None, initialize=True, **more):
        client = Client([options.isogloss, "lsp", "--stdio"], options.seconds)
        self.addCleanup(client.kill)
        if initialize:
            client.initialize(settings, **more)
        return client

    def opened(self, text, name="part.nc", dialect="fanuc", settings=None, **more):
        client = self.client({"dialect": dialect, **(settings or {})}, **more)
        uri = "file:///nowhere/" + name
        client.open(uri, text)
        return client, uri


class Lifecycle(Script):
    def test_begins_and_ends_as_the_protocol_says(self):
        client = self.client(initialize=False)
        result = client.initialize()
        self.assertEqual(result["serverInfo"]["name"], "isogloss")
        self.assertEqual(result["capabilities"]["positionEncoding"], "utf-16")
        self.assertEqual(client.end(), 0)

    def test_utf8_where_the_client_offers_it(self):
        client = self.client(initialize=False)
        self.assertEqual(client.initialize(encodings=["utf-16", "utf-8"])["capabilities"]["positionEncoding"], "utf-8")

    def test_exit_without_shutdown_is_a_failure(self):
        client = self.client()
        client.notify("exit")
        self.assertEqual(client.process.wait(options.seconds), 1)

    def test_ends_when_the_client_is_gone(self):
        client = self.client()
        client.process.stdin.close()
        self.assertEqual(client.process.wait(options.seconds), 1)

    def test_refuses_requests_out_of_order(self):
        client = self.client(initialize=False)
        with self.assertRaises(Failed) as early:
            client.at("hover", "file:///a.nc", 0, 0)
        self.assertEqual(early.exception.code, -32002)
        client.initialize()
        with self.assertRaises(Failed):
            client.request("initialize", {"capabilities": {}})
        client.request("shutdown")
        with self.assertRaises(Failed) as late:
            client.at("hover", "file:///a.nc", 0, 0)
        self.assertEqual(late.exception.code, -32600)


class Robust(Script):
    def test_every_bad_message_gets_an_error(self):
        client = self.client()
        for body, code in ((b"{", -32700), (b"\xff\xfe", -32700), (b"[" * 100000, -32700), (b"7", -32600), (b"[]", -32600),
                           (b'{"jsonrpc":"2.0","id":null,"method":"x"}', -32600),
                           (b'{"jsonrpc":"2.0","id":5,"method":7}', -32600)):
            client.send(frame(body))
            self.assertEqual(client.response(None)["error"]["code"], code, body[:40])
        with self.assertRaises(Failed) as unknown:
            client.request("textDocument/unheardOf")
        self.assertEqual(unknown.exception.code, -32601)
        client.notify("$/unheardOf", {"a": 1})
        client.send(frame({"jsonrpc": "2.0", "id": 77, "result": None}))
        self.assertEqual(client.end(), 0)

    def test_wrong_params_are_the_clients_fault(self):
        client, uri = self.opened(FANUC)
        wrong = [None, 7, "text", [], {}, {"textDocument": 7}, {"textDocument": {"uri": 7}}, {"textDocument": {"uri": uri}},
                 {"textDocument": {"uri": uri}, "position": {"line": -1, "character": 0}},
                 {"textDocument": {"uri": uri}, "position": {"line": 1.5, "character": "x"}},
                 {"textDocument": {"uri": "file:///not/open.nc"}, "position": {"line": 0, "character": 0}}]
        methods = ["hover", "definition", "references", "completion", "rename", "prepareRename", "documentHighlight",
                   "inlayHint", "codeAction", "rangeFormatting", "semanticTokens/range"]
        for method in methods:
            for params in wrong:
                number = client.start("textDocument/" + method, params)
                self.assertEqual(client.response(number)["error"]["code"], -32602, f"{method} {params}")
        for method in ("didOpen", "didChange", "didClose", "didSave"):
            for params in wrong[:7]:
                client.notify("textDocument/" + method, params)
        self.assertIsNotNone(client.at("hover", uri, 6, 5))

    def test_places_outside_the_text_are_answered(self):
        client, uri = self.opened(FANUC)
        for line, character in ((0, 10**6), (10**6, 0), (2**31 - 1, 2**31 - 1)):
            for method in ("hover", "definition", "completion", "documentHighlight", "prepareRename"):
                client.at(method, uri, line, character)
            client.at("references", uri, line, character, context={"includeDeclaration": True})
        outside = {"start": {"line": 10**6, "character": 0}, "end": {"line": 3, "character": 9}}
        for method in ("inlayHint", "semanticTokens/range", "rangeFormatting"):
            client.about(method, uri, range=outside, options={"tabSize": 2, "insertSpaces": True})

    def test_broken_texts_have_an_answer_to_each_request(self):
        noise = random.Random(7)
        binary = "".join(chr(noise.randrange(1, 256)) for _ in range(5000))
        texts = {"empty": "", "blanks": " \n\t\n", "binary": binary, "one long line": "G1 X1 " * 100000, "cut": FANUC[:150],
                 "prose": "This is no program.\n" * 100, "surrogates": "(\U0001F600\U0001F600) G1 X1\n", "zero": "G1\0X1\n",
                 "cr": "G1 X1\rG1 X2\r", "mixed": "G1 X1\r\nG1\rX2\n"}
        client = self.client()
        for name, text in texts.items():
            for dialect_file in (f"{name}.nc", f"{name}.mpf", f"{name}.h"):
                uri = "file:///nowhere/" + dialect_file.replace(" ", "%20")
                client.open(uri, text)
                client.diagnostics(uri)
                self.ask_everything(client, uri, 0, 3)
        self.assertEqual(client.end(), 0)

    def ask_everything(self, client, uri, line, character):
        whole = {"start": {"line": 0, "character": 0}, "end": {"line": 100, "character": 0}}
        for method in ("hover", "definition", "completion", "documentHighlight", "prepareRename"):
            client.at(method, uri, line, character)
        client.at("references", uri, line, character, context={"includeDeclaration": False})
        for method in ("documentSymbol", "foldingRange", "semanticTokens/full"):
            client.about(method, uri)
        client.about("inlayHint", uri, range=whole)
        client.about("codeAction", uri, range=whole, context={"diagnostics": []})
        number = client.start("textDocument/formatting", {"textDocument": {"uri": uri}, "options": {}})
        answer = client.response(number)
        self.assertTrue("result" in answer or answer["error"]["code"] == -32803, answer)
        return answer

    def test_a_cancelled_request_is_answered_as_cancelled(self):
        client, uri = self.opened("G1 X1 F1\n" * 50000)
        number = client.start("textDocument/hover", {"textDocument": {"uri": uri}, "position": {"line": 9, "character": 1}})
        other = client.start("textDocument/hover", {"textDocument": {"uri": uri}, "position": {"line": 9, "character": 1}})
        client.notify("$/cancelRequest", {"id": other})
        client.response(number)
        answer = client.response(other)
        self.assertTrue("result" in answer or answer["error"]["code"] in (-32800, -32803), answer)

    def test_a_loop_without_end_ends_in_time(self):
        client, uri = self.opened("O1\nN1 G1 X1 F1\nGOTO 1\nM30\n", settings={"budgetMs": 300})
        codes = {d["code"] for d in client.diagnostics(uri)}
        self.assertTrue(codes & {"IG-0661", "IG-0417", "IG-0418"}, codes)

    def test_a_text_full_of_faults_has_a_short_list(self):
        client, uri = self.opened("X1 E1\n" * 500, settings={"maxDiagnostics": 20})
        found = client.diagnostics(uri)
        self.assertEqual(len(found), 21)
        self.assertIn("IG-0662", [d["code"] for d in found])

    def test_a_wrong_setting_is_told_and_ignored(self):
        client = self.client({"dialect": 7, "inlayHints": {"machine": "yes"}})
        uri = "file:///nowhere/a.nc"
        client.open(uri, "G1 X1\n")
        client.diagnostics(uri)
        told = [n["params"]["message"] for n in client.notifications if n["method"] == "window/showMessage"]
        self.assertEqual(len(told), 2, told)
        client = self.client({"dialect": "no-such-dialect"})
        client.open(uri, "G1 X1\n")
        self.assertIn("IG-0101", [d["code"] for d in client.diagnostics(uri)])
        client = self.client({"set": ["nonsense"]})
        client.open(uri, "G1 X1\n")
        self.assertIn("IG-0660", [d["code"] for d in client.diagnostics(uri)])


class Programs(Script):
    def test_diagnostics_follow_the_text(self):
        client, uri = self.opened(FANUC)
        found = client.diagnostics(uri, 1)
        line, character = place(FANUC, "E7")
        self.assertIn({"start": {"line": line, "character": character}, "end": {"line": line, "character": character + 2}},
                      [d["range"] for d in found if d["code"] == "ISO-0285"])
        self.assertTrue(next(d for d in found if d["code"] == "ISO-0285")["data"]["explanation"])
        client.change(uri, 2, {"range": {"start": {"line": line, "character": character - 1},
                                         "end": {"line": line, "character": character + 2}}, "text": ""})
        self.assertNotIn("ISO-0285", [d["code"] for d in client.diagnostics(uri, 2)])

    def test_columns_count_utf16_units(self):
        text = "O1\n(\U0001F600 Fr\u00e4sen) G1 X1 F100 E7\nM30\n"
        for encodings, unit in ((None, 2), (["utf-8"], 1)):
            client, uri = self.opened(text, encodings=encodings)
            wanted = text.split("\n")[1].index("E7")
            before = text.split("\n")[1][:wanted]
            wanted = len(before.encode("utf-16-le")) // 2 if unit == 2 else len(before.encode())
            starts = [d["range"]["start"]["character"] for d in client.diagnostics(uri) if d["code"] == "ISO-0285"]
            self.assertEqual(starts, [wanted])

    def test_hover_tells_word_machine_and_sentence(self):
        client, uri = self.opened(FANUC)
        text = client.at("hover", uri, *place(FANUC, "G81", inside=1))["contents"]["value"]
        for part in ("**G81**", "DrillingCycleSyntax", "Machine:", "Line 7", "#101"):
            self.assertIn(part, text)
        text = client.at("hover", uri, *place(FANUC, "E7"))["contents"]["value"]
        self.assertIn("ISO-0285", text)
        self.assertIsNone(client.at("hover", uri, 10**5, 0))

    def test_definition_of_variable_label_and_subprogram(self):
        client, uri = self.opened(FANUC)
        found = client.at("definition", uri, *place(FANUC, "#101", 1, 2))[0]
        self.assertEqual(found["range"]["start"]["line"], place(FANUC, "#101")[0])
        found = client.at("definition", uri, *place(FANUC, "P100", inside=1))
        self.assertEqual([f["range"]["start"]["line"] for f in found], [place(FANUC, "O0100")[0]])

    def test_a_subprogram_in_another_file_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            sub = pathlib.Path(folder, "O0200.nc")
            sub.write_text("O0200\nG1 X5. F100 E9\nM99\n")
            client = self.client({"dialect": "fanuc"})
            text = "O0001\nM98 P200\nM30\n"
            uri = uri_of(pathlib.Path(folder, "main.nc"))
            client.open(uri, text)
            found = client.at("definition", uri, *place(text, "P200"))
            self.assertEqual([f["uri"] for f in found], [uri_of(sub)])
            fault = next(d for d in client.diagnostics(uri) if d["code"] == "ISO-0285")
            self.assertEqual(fault["range"]["start"]["line"], 1)
            self.assertEqual(fault["relatedInformation"][0]["location"]["uri"], uri_of(sub))

    def test_references_and_rename_of_a_siemens_label(self):
        client, uri = self.opened(SIEMENS, "part.mpf", "siemens")
        at = place(SIEMENS, "START", 1, 2)
        found = client.at("references", uri, *at, context={"includeDeclaration": True})
        self.assertEqual([f["range"]["start"]["line"] for f in found], [3, 6])
        self.assertEqual(client.at("definition", uri, *at)[0]["range"]["start"]["line"], 3)
        self.assertEqual(client.at("prepareRename", uri, *at)["placeholder"], "START")
        edits = client.at("rename", uri, *at, newName="LOOP")["changes"][uri]
        self.assertEqual(applied(SIEMENS, edits), SIEMENS.replace("START", "LOOP"))

    def test_rename_of_a_variable_and_its_refusals(self):
        client, uri = self.opened(SIEMENS, "part.mpf", "siemens")
        at = place(SIEMENS, "R2", 1)
        edits = client.at("rename", uri, *at, newName="R20")["changes"][uri]
        self.assertEqual(applied(SIEMENS, edits), SIEMENS.replace("R2", "R20"))
        for name in ("R1", "", "A B", "X"):
            with self.assertRaises(Failed, msg=name):
                client.at("rename", uri, *at, newName=name)
        with self.assertRaises(Failed):
            client.at("rename", uri, *place(SIEMENS, "M30"), newName="M2")

    def test_klartext_labels_and_variables(self):
        client, uri = self.opened(KLARTEXT, "part.h", "heidenhain")
        at = place(KLARTEXT, "CALL LBL 1", inside=9)
        self.assertEqual(client.at("definition", uri, *at)[0]["range"]["start"]["line"], 3)
        found = client.at("references", uri, *at, context={"includeDeclaration": False})
        self.assertEqual([f["range"]["start"]["line"] for f in found], [7])
        found = client.at("references", uri, *place(KLARTEXT, "Q1", 1), context={"includeDeclaration": True})
        self.assertEqual(len(found), 4)
        edits = client.at("rename", uri, *at, newName="7")["changes"][uri]
        self.assertEqual(applied(KLARTEXT, edits), KLARTEXT.replace("LBL 1", "LBL 7"))

    def test_outline_and_folding(self):
        client, uri = self.opened(FANUC)
        outline = client.about("documentSymbol", uri)
        self.assertEqual([s["name"] for s in outline if s["kind"] == 2], ["O0001", "O0100"])
        self.assertIn("Tool 1", [s["name"] for s in outline[0]["children"]])
        folds = [(f["startLine"], f["endLine"]) for f in client.about("foldingRange", uri)]
        self.assertIn((6, 8), folds)  # the cycle
        self.assertIn((11, 14), folds)  # the loop

    def test_completion_comes_from_the_dialect(self):
        client, uri = self.opened(FANUC)
        items = client.at("completion", uri, *place(FANUC, "E7"))["items"]
        labels = [i["label"] for i in items]
        self.assertIn("G81", labels)
        self.assertIn("#101", labels)
        first = sorted(items, key=lambda i: i["sortText"])[0]
        self.assertEqual(first["detail"], "word of G81")
        self.assertTrue(next(i for i in items if i["label"] == "G83")["documentation"]["value"])
        client, uri = self.opened(KLARTEXT, "part.h", "heidenhain")
        self.assertTrue(client.at("completion", uri, 4, 2)["items"])

    def test_inlay_hints_and_their_switches(self):
        whole = {"start": {"line": 0, "character": 0}, "end": {"line": 99, "character": 0}}
        client, uri = self.opened(FANUC)
        hints = [h["label"] for h in client.about("inlayHint", uri, range=whole) if h["position"]["line"] == 7]
        self.assertEqual(len(hints), 2, hints)
        self.assertIn("G81", hints[0])
        self.assertIn("machine X60", hints[1])
        client, uri = self.opened(FANUC, settings={"inlayHints": {"machine": False, "modal": False}})
        self.assertEqual(client.about("inlayHint", uri, range=whole), [])
        client.notify("workspace/didChangeConfiguration",
                      {"settings": {"isogloss": {"dialect": "fanuc", "inlayHints": {"machine": True, "modal": False}}}})
        self.assertTrue(client.about("inlayHint", uri, range=whole))

    def test_semantic_tokens_cover_the_text(self):
        client, uri = self.opened(FANUC)
        data = client.about("semanticTokens/full", uri)["data"]
        self.assertEqual(len(data) % 5, 0)
        line, character, seen = 0, 0, {}
        for i in range(0, len(data), 5):
            character = character + data[i + 1] if data[i] == 0 else data[i + 1]
            line += data[i]
            seen[FANUC.split("\n")[line][character:character + data[i + 2]]] = data[i + 3]
        self.assertEqual((seen["G81"], seen["Y30."], seen["(HOLES)"]), (0, 1, 2))
        part = client.about("semanticTokens/range", uri, range={"start": {"line": 6, "character": 0},
                                                                "end": {"line": 7, "character": 0}})["data"]
        self.assertTrue(0 < len(part) < len(data))

    def test_formatting_changes_blanks_and_no_motion(self):
        client, uri = self.opened("O1\nG90G54G1X10Y20F100  \n  X3    Y4 (A  B)\nM30\n")
        edits = client.about("formatting", uri, options={})
        text = applied("O1\nG90G54G1X10Y20F100  \n  X3    Y4 (A  B)\nM30\n", edits)
        self.assertEqual(text, "O1\nG90 G54 G1 X10 Y20 F100\n  X3 Y4 (A  B)\nM30\n")

    def test_block_numbers_are_written_anew_where_nothing_goes(self):
        text = "O1\nN7 #1=0\nN3 #1=#1+1\nN5 G1 X#1 F100\nIF [#1 LT 3] GOTO 3\nN9 M30\n"
        client, uri = self.opened(text, settings={"format": {"blockNumbers": True, "step": 100}})
        edits = client.about("formatting", uri, options={})
        wanted = text.replace("N7", "N100").replace("N5", "N300").replace("N9", "N400")
        self.assertEqual(applied(text, edits), wanted)

    def test_requests_on_real_programs(self):
        """Of each brand: what the server says equals what `run` says, and every request has an answer."""
        programs = sorted((options.source / "tests/programs").glob("*/**/*.nc")) + sorted(
            (options.source / "tests/programs").glob("*/**/*.mpf")) + sorted((options.source / "tests/programs").glob("*/**/*.h"))
        chosen = random.Random(3).sample(programs, options.programs)
        client = self.client({"maxDiagnostics": 100000})
        for path in chosen:
            uri, text = uri_of(path), path.read_bytes().decode("utf-8", "replace").replace("\r\n", "\n")
            client.open(uri, text)
            said = client.diagnostics(uri)
            lines = text.split("\n")
            for line in range(0, len(lines), max(1, len(lines) // 5)):
                Robust.ask_everything(self, client, uri, line, len(lines[line]) // 2)
            if "\r" not in text and path.read_bytes().isascii():
                self.compare_with_run(path, said)
        self.assertEqual(client.end(), 0)

    def compare_with_run(self, path, said):
        done = subprocess.run([options.isogloss, "run", str(path), "--emit", "none", "--diagnostics", "json", "--repeats",
                               "0"], capture_output=True, text=True)
        wanted = sorted((d["Line"], d["Code"]) for d in map(json.loads, done.stderr.splitlines())
                        if d.get("File") == str(path) and d["Code"] not in ("IG-0514", "IG-0518") and "Line" in d)
        here = sorted((d["range"]["start"]["line"] + 1, d["code"]) for d in said
                      if not d["message"].startswith("in the called program"))
        self.assertEqual([x for x in here if x[0] > 0 and x in wanted], wanted, str(path))


class Dialects(Script):
    XML = """<?xml version="1.0" encoding="UTF-8"?>
<Dialect xmlns="urn:isogloss:dialect:1" name="mine" title="Mine" extends="fanuc">
  <Chain>
    <Configure syntax="FlagSyntax" splitnumbers="join"/>
    <InsertBefore syntax="WordSyntax"> <CornerBrakeSyntax/> </InsertBefore>
  </Chain>
</Dialect>
"""

    def test_lint_as_you_type_and_a_quick_fix(self):
        client = self.client()
        uri = "file:///nowhere/mine.xml"
        client.open(uri, self.XML, "xml")
        found = client.diagnostics(uri, 1)
        self.assertTrue(found)
        whole = {"start": {"line": 0, "character": 0}, "end": {"line": 9, "character": 0}}
        actions = client.about("codeAction", uri, range=whole, context={"diagnostics": found})
        self.assertTrue(actions, found)
        text = self.XML
        for _ in range(5):
            if not actions:
                break
            text = applied(text, actions[0]["edit"]["changes"][uri])
            client.change(uri, 2, {"text": text})
            found = client.diagnostics(uri, 2)
            actions = client.about("codeAction", uri, range=whole, context={"diagnostics": found})
        self.assertIn("split-numbers", text)

    def test_completion_of_syntaxes_options_and_choices(self):
        client = self.client()
        uri = "file:///nowhere/mine.xml"
        client.open(uri, self.XML.replace("<CornerBrakeSyntax/>", "<WordSyntax expressions=\"\" />"), "xml")
        text = self.XML.replace("<CornerBrakeSyntax/>", "<WordSyntax expressions=\"\" />")
        elements = client.at("completion", uri, *place(text, "<WordSyntax", inside=1))["items"]
        self.assertIn("DrillingCycleSyntax", [i["label"] for i in elements])
        attributes = client.at("completion", uri, *place(text, "expressions=", inside=0))["items"]
        self.assertIn("split-numbers", [i["label"] for i in attributes])
        values = client.at("completion", uri, *place(text, 'expressions="', inside=13))["items"]
        self.assertIn("pass", [i["label"] for i in values])
        self.assertIn("WordSyntax", client.at("hover", uri, *place(text, "<WordSyntax", inside=4))["contents"]["value"])
        self.assertTrue(client.about("documentSymbol", uri))

    def test_programs_follow_a_saved_dialect(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "mine.xml")
            text = '<Dialect xmlns="urn:isogloss:dialect:1" name="mine" title="Mine" extends="fanuc">\n</Dialect>\n'
            file.write_text(text)
            client = self.client({"dialect": str(file)})
            program = "file:///nowhere/a.nc"
            client.open(program, "O1\nM30\n")
            client.diagnostics(program)
            broken = text.replace("</Dialect>", '<Chain><Remove syntax="NoSuchSyntax"/></Chain></Dialect>')
            client.open(uri_of(file), broken, "xml")
            self.assertIn("IG-0112", [d["code"] for d in client.diagnostics(uri_of(file))])
            file.write_text(broken)
            client.notify("textDocument/didSave", {"textDocument": {"uri": uri_of(file)}})
            self.assertIn("IG-0112", [d["code"] for d in client.diagnostics(program)])

    def test_shipped_dialects_and_machines_are_clean(self):
        client = self.client()
        files = [options.source / "dialects/fanuc.xml", options.source / "dialects/siemens.xml"]
        files += sorted((options.source / "dialects/machines").glob("*/machine.xml"))[:2]
        for file in files:
            client.open(uri_of(file), file.read_text(), "xml")
            self.assertEqual([d for d in client.diagnostics(uri_of(file)) if d["severity"] == 1], [], file)


class Crashes(Script):
    """A plugin that misbehaves when told to: the session goes on."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.dialect = pathlib.Path(folder.name, "bad.xml")
        self.dialect.write_text('<Dialect xmlns="urn:isogloss:dialect:1" name="bad" title="Bad" extends="fanuc">'
                                '<Plugins><Plugin name="cli_bad_plugin"/></Plugins><Chain>'
                                '<InsertBefore syntax="WordSyntax"><MisbehaveSyntax/></InsertBefore>'
                                "</Chain></Dialect>")

    def crash(self, statement, more=()):
        client = Client([options.isogloss, "lsp", "--plugins", options.bad_plugins, *more], options.seconds)
        self.addCleanup(client.kill)
        client.initialize({"dialect": str(self.dialect)})
        client.open("file:///nowhere/good.nc", "O1\nG1 X1 F1 E7\nM30\n")
        self.assertIn("ISO-0285", [d["code"] for d in client.diagnostics("file:///nowhere/good.nc")])
        uri = "file:///nowhere/bad.nc"
        client.open(uri, f"O1\n{statement}\nM30\n")
        number = client.start("textDocument/hover", {"textDocument": {"uri": uri}, "position": {"line": 1, "character": 0}})
        answer = client.response(number)
        self.assertTrue("error" in answer or "isogloss" in str(answer) or "**" in str(answer), answer)
        found = client.diagnostics(uri)
        self.assertEqual([d["code"] for d in found], ["IG-0663"])
        told = [n["params"]["message"] for n in client.notifications if n["method"] == "window/showMessage"]
        self.assertIn("bad.nc", " ".join(told))
        self.assertIn("ISO-0285", [d["code"] for d in client.diagnostics("file:///nowhere/good.nc")])
        client.change(uri, 2, {"range": {"start": {"line": 1, "character": 0}, "end": {"line": 2, "character": 0}}, "text": ""})
        self.assertEqual([d["code"] for d in client.diagnostics(uri, 2)], [])
        self.assertEqual(client.end(), 0)

    def test_a_plugin_that_crashes(self):
        self.crash("M901")

    def test_a_plugin_that_aborts(self):
        self.crash("M904")

    @unittest.skipIf("TSAN_OPTIONS" in os.environ, "the thread sanitizer keeps a signal until the program calls the C library")
    def test_a_plugin_that_never_returns(self):
        self.crash("M902", ["--watchdog", "1"])

    def test_a_plugin_that_throws_is_a_diagnostic(self):
        client = Client([options.isogloss, "lsp", "--plugins", options.bad_plugins], options.seconds)
        self.addCleanup(client.kill)
        client.initialize({"dialect": str(self.dialect)})
        client.open("file:///nowhere/bad.nc", "O1\nM903\nM30\n")
        self.assertIn("IG-0401", [d["code"] for d in client.diagnostics("file:///nowhere/bad.nc")])
        self.assertEqual(client.end(), 0)


def main():
    global options
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--isogloss", required=True)
    parser.add_argument("--source", required=True, type=pathlib.Path)
    parser.add_argument("--bad-plugins", required=True)
    parser.add_argument("--seconds", type=float, default=30)
    parser.add_argument("--programs", type=int, default=25)
    options, rest = parser.parse_known_args()
    unittest.main(argv=["lsp_test.py", *rest])


main()
