#!/usr/bin/env python3
"""Pages and pictures of paths without a browser: what stands in them, and what the server of a page answers.

  page_test.py --isogloss PATH
"""
import argparse
import base64
import http.client
import json
import pathlib
import re
import signal
import struct
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ET

HERE = pathlib.Path(__file__).resolve().parent
PART = HERE / "part.nc"
TOOLS = ["-d", "fanuc", "--tools", HERE / "tools.xml"]
SVG = "{http://www.w3.org/2000/svg}"


def isogloss(*arguments, status=0, **options):
    done = subprocess.run([options.pop("path", ARGUMENTS.isogloss), *map(str, arguments)], capture_output=True, timeout=120,
                          **options)
    if status is not None and done.returncode != status:
        raise AssertionError(f"status {done.returncode}, not {status}: {done.stderr.decode(errors='replace')}")
    return done


def page_of(*arguments, status=0, **options):
    """The facts of a page, and the page."""
    text = isogloss("view", *arguments, status=status, **options).stdout.decode()
    facts = json.loads(re.search(r'<script type="application/json" id="facts">(.*?)</script>', text, re.S)[1])
    return facts, text


def data_of(text, name):
    return base64.b64decode(re.search(rf'id="{name}">([^<]*)</script>', text)[1])


def summary_of(*arguments):
    return json.loads(isogloss("run", *arguments, "--emit", "none", "--summary", "--json", status=None).stdout)


class Plot(unittest.TestCase):
    def plot(self, *arguments, **options):
        return ET.fromstring(isogloss("plot", *arguments, **options).stdout)

    def test_arcs_are_arcs_and_rapids_are_dashed(self):
        root = self.plot(PART, *TOOLS)
        paths = root.findall(SVG + "path")
        arcs = [p for p in paths if "a" in p.get("d", "") and p.get("class", "").startswith("c")]
        self.assertGreaterEqual(len(arcs), 2)  # from above, and isometric
        self.assertRegex(arcs[0].get("d"), r"a[\d.]+ [\d.]+ -?[\d.]+ 0 [01] ")
        self.assertEqual(sum(p.get("class") == "rapid" and len(p.get("d")) > 30 for p in paths), 4)
        self.assertIn("stroke-dasharray", root.find(SVG + "style").text)

    def test_the_legend_names_tools_extents_and_scale(self):
        text = "\n".join(t.text for t in self.plot(PART, *TOOLS).iter(SVG + "text"))
        self.assertIn("T1 END MILL <12>", text)
        self.assertIn("T2 DRILL 8", text)
        self.assertIn("X -70 to 70 mm (140)", text)
        self.assertIn("Z -12 to 50 mm (62)", text)
        self.assertRegex(text, r"\b(1|2|5)0* mm\b")

    def test_extents_hold_the_bulge_of_an_arc(self):
        done = isogloss("plot", "-", "-d", "fanuc", input=b"G90 G17 G54\nG0 X0 Y0 Z0\nG2 X10. Y0 R5. F100\nM30\n")
        self.assertIn(b"Y 0 to 5 mm", done.stdout)

    def test_a_long_program_is_thinned_and_says_so(self):
        rows = ["G90 G17 G54 G0 X0 Y0 Z0", "G1 F900 X0"]
        rows += [f"X{(i * 37 % 4001) / 40:.3f} Y{i / 600:.3f} Z{(i % 7) / 10:.1f}" for i in range(60000)]
        done = isogloss("plot", "-", "-d", "fanuc", input="\n".join([*rows, "Z77.", "M30"]).encode())
        self.assertLess(len(done.stdout), 1_500_000)
        self.assertIn(b"Thinned to what can be seen", done.stdout)
        self.assertIn(b"Z 0 to 77 mm", done.stdout)

    def test_a_program_without_moves_is_said_to_have_none(self):
        done = isogloss("plot", "-", "-d", "fanuc", input=b"M30\n")
        self.assertIn(b"[IG-0651]", done.stderr)
        ET.fromstring(done.stdout)

    def test_a_picture_of_another_form_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            picture = pathlib.Path(folder) / "part.PNG"
            done = isogloss("plot", PART, *TOOLS, "-o", picture, status=2)
            self.assertIn("pictures are written as SVG only, not as png [IG-0653]", done.stderr.decode())
            self.assertFalse(picture.exists())
            isogloss("plot", PART, *TOOLS, "-o", picture.with_suffix(".svg"))
            self.assertIn("[IG-0653]", isogloss("dialect", "iso", "--graph", "-o", picture, status=2).stderr.decode())

    def test_more_moves_than_allowed_end_the_picture(self):
        done = isogloss("plot", PART, *TOOLS, "--max-moves", 5)
        self.assertIn(b"the picture ends after 5 moves", done.stderr)
        self.assertIn(b"[IG-0650]", done.stderr)
        facts, _ = page_of(PART, *TOOLS, "--max-moves", 5)
        self.assertEqual((facts["paths"][0]["moves"], facts["paths"][0]["isCut"]), (5, True))

    def test_bytes_that_are_no_program_give_a_picture(self):
        for text in (b"", bytes(range(256)) * 40, b"G1 X1e308 Y-1e308 F1\nX0\n", b"G1 X9" + b"9" * 300 + b"\nX1\n"):
            done = isogloss("plot", "-", "-d", "fanuc", input=text, status=None)
            self.assertIn(done.returncode, (0, 1), done.stderr)
            ET.fromstring(done.stdout)


class Page(unittest.TestCase):
    def test_no_text_of_a_program_becomes_markup(self):
        facts, text = page_of(PART, *TOOLS)
        self.assertEqual(text.lower().count("<script"), text.lower().count("</script>"))
        self.assertNotIn("HACKED", re.sub(r'id="text-0">[^<]*', "", text).replace("\\u003c/SCRIPT>\\u003cSCRIPT>WINDOW.HACKED", ""))
        self.assertEqual(data_of(text, "text-0"), PART.read_bytes())
        self.assertEqual(facts["paths"][0]["tools"][1]["name"], "END MILL <12>")

    def test_the_policy_allows_the_page_and_nothing_else(self):
        text = page_of(PART, *TOOLS)[1]
        policy = re.search(r'http-equiv="Content-Security-Policy" content="([^"]*)"', text)[1]
        self.assertIn("default-src 'none'", policy)
        self.assertNotIn("unsafe", policy)
        self.assertNotIn("connect-src", policy)
        self.assertNotRegex(text.split("<script", 1)[0], r"(src|href)=")

    def test_the_columns_hold_the_moves_of_the_run(self):
        facts, text = page_of(PART, *TOOLS)
        path, data = facts["paths"][0], data_of(text, "path-0")
        motions = [json.loads(line) for line in isogloss("run", PART, *TOOLS, status=None).stdout.splitlines()]
        moves = [m for m in motions if m["Event"] in ("rapid", "feed", "arc", "dwell")]
        self.assertEqual(path["moves"], len(moves))
        lines = struct.unpack_from(f"<{len(moves)}I", data, 12 * path["points"])
        self.assertEqual(list(lines), [m["Line"] for m in moves])
        last = struct.unpack_from("<3f", data, 12 * (path["points"] - 1))
        z = [p + o for p, o in zip(last, path["origin"])][2]
        self.assertAlmostEqual(z, moves[-1]["MachineCoordinate"]["Z"] - 95.5, places=4)  # the tip of tool 2

    def test_times_are_those_of_the_summary(self):
        options = [HERE.parent / "programs/fanuc/demo.nc", "-d", "fanuc", "-m", "ac-table"]
        facts = page_of(*options, status=None)[0]["paths"][0]
        summary = summary_of(*options)
        for name, key in (("rapidSeconds", "RapidTime_s"), ("feedSeconds", "FeedTime_s"), ("dwellSeconds", "DwellTime_s")):
            if summary.get(key) is not None:
                self.assertAlmostEqual(facts[name], summary[key], delta=1e-3 + 1e-6 * summary[key], msg=name)

    def test_each_line_of_a_short_program_is_explained(self):
        facts, _ = page_of(PART, *TOOLS)
        self.assertIn("900", facts["explanations"][0]["0"]["10"])
        self.assertIsNone(page_of(PART, *TOOLS, "--explain-lines", 5)[0]["explanations"])

    def test_diagnostics_stand_with_their_lines(self):
        facts, _ = page_of(PART, *TOOLS)
        self.assertIn((31, "ISO-0285"), [(d["line"], d["code"]) for d in facts["diagnostics"]])

    def test_two_dialects_are_marked_where_they_part(self):
        program = b"G90 G17 G54 G21\nT1 M6\nG0 X0 Y0 Z5.\nG1 Z-1. F100\nX10\nX20.\nM30\n"
        facts, text = page_of("-", "-a", "fanuc", "-b", "haas", status=None, input=program)
        self.assertEqual([p["dialect"] for p in facts["paths"]], ["fanuc", "haas"])
        flags = [data_of(text, f"path-{i}")[-p["moves"]:] for i, p in enumerate(facts["paths"])]
        lines = {d["line"] for d in facts["differences"]}
        self.assertEqual(any(f & 8 for f in flags[0] + flags[1]), bool(lines))
        same, _ = page_of("-", "-a", "fanuc", "-b", "fanuc", status=None, input=program)
        self.assertEqual(same["differences"], [])

    def test_bytes_that_are_no_program_give_a_page(self):
        for text in (b"", bytes(range(256)) * 40, b"\r\r\n\nG1 X1\r"):
            facts, page = page_of("-", "-d", "fanuc", input=text, status=None)
            self.assertEqual(data_of(page, "text-0"), text)

    def test_options_that_contradict_each_other_are_refused(self):
        for options in (["--serve", "-o", "x.html"], ["--port", "80"], ["--serve", "--port", "70000"]):
            self.assertIn(b"[IG-0513]", isogloss("view", PART, *options, status=2).stderr)


class Served:
    """`isogloss view --serve`, and questions to it."""

    def __init__(self, *arguments):
        self.process = subprocess.Popen([ARGUMENTS.isogloss, "view", *map(str, arguments), "--serve"],
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.address = self.process.stdout.readline().decode().strip()
        self.port = int(self.address.rstrip("/").rsplit(":", 1)[1])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.send_signal(signal.SIGINT)
        self.status = self.process.wait(20)
        self.process.stdout.close()
        self.process.stderr.close()

    def get(self, target, host=None, method="GET"):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        connection.putrequest(method, target, skip_host=True)
        connection.putheader("Host", f"127.0.0.1:{self.port}" if host is None else host)
        connection.endheaders()
        answer = connection.getresponse()
        body = answer.read()
        connection.close()
        return answer.status, body, answer


class Serve(unittest.TestCase):
    def test_it_answers_three_addresses_of_its_own_name(self):
        with Served(PART, *TOOLS) as served:
            self.assertRegex(served.address, r"^http://127\.0\.0\.1:\d+/$")
            status, body, answer = served.get("/")
            self.assertEqual(status, 200)
            self.assertIn(b'id="facts"', body)
            self.assertIn("frame-ancestors 'none'", answer.getheader("Content-Security-Policy"))
            self.assertEqual(json.loads(served.get("/version")[1])["version"], 1)
            self.assertIn(b"900", served.get("/explain?path=0&file=0&line=10")[1])
            for host in ("example.com", f"example.com:{served.port}", "127.0.0.1", ""):
                self.assertEqual(served.get("/", host)[0], 403, host)
            for target in ("/etc/passwd", "/../part.nc", "//", "/part.nc", "/%2e%2e/x", "/page.css"):
                self.assertEqual(served.get(target)[0], 404, target)
            for query in ("", "?path=0&file=0", "?path=9&file=0&line=1", "?path=0&file=7&line=1", "?path=0&file=0&line=-1",
                          "?path=0&file=../x&line=1"):
                self.assertEqual(served.get("/explain" + query)[0], 400, query)
            self.assertEqual(served.get("/", method="POST")[0], 405)
        self.assertEqual(served.status, 0)

    def test_it_runs_the_program_again_when_a_file_changes(self):
        with tempfile.TemporaryDirectory() as folder:
            part, tools = pathlib.Path(folder, "p.nc"), pathlib.Path(folder, "t.xml")
            part.write_bytes(PART.read_bytes())
            tools.write_bytes((HERE / "tools.xml").read_bytes())
            with Served(part, "-d", "fanuc", "--tools", tools) as served:
                part.write_bytes(PART.read_bytes().replace(b"X-60. Y-40.\n", b"X-60. Y-40.\nX-61.\n", 1))
                self.assertEqual(json.loads(served.get("/version")[1])["version"], 2)
                self.assertIn(base64.b64encode(part.read_bytes())[:40], served.get("/")[1])
                tools.write_bytes(tools.read_bytes().replace(b"DRILL 8", b"DRILL 9"))
                self.assertEqual(json.loads(served.get("/version")[1])["version"], 3)
                self.assertIn(b"DRILL 9", served.get("/")[1])
                part.unlink()
                self.assertNotEqual(json.loads(served.get("/version")[1])["failure"], "")
                part.write_bytes(PART.read_bytes())
                self.assertEqual(json.loads(served.get("/version")[1])["failure"], "")

    def test_a_port_that_is_taken_is_reported(self):
        with Served(PART, *TOOLS) as served:
            done = isogloss("view", PART, *TOOLS, "--serve", "--port", served.port, status=2)
            self.assertIn(b"[IG-0652]", done.stderr)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True)
    ARGUMENTS, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])
