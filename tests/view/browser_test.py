#!/usr/bin/env python3
"""The page of `isogloss view` in a real Chromium: what a person clicks, and what the page shows then.

  browser_test.py --isogloss PATH [--update] [--pictures DIR]

--update writes the reference picture anew; --pictures keeps screenshots, to be looked at. Status 77 where Chromium or its
driver is not installed.
"""
import argparse
import base64
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import browser
from page_test import Served
import page_test

HERE = pathlib.Path(__file__).resolve().parent
PART = HERE / "part.nc"
TOOLS = ["-d", "fanuc", "--tools", HERE / "tools.xml"]
FACES = HERE.parent / "five_axis" / "faces.nc"
FACES_OPTIONS = ["-d", "fanuc", "-m", "ac-table", "--set", "ToolOffsetTable.1.H=95.5", "--set", "ToolOffsetTable.2.H=143.25",
                 "--set", "IsoCoordinateTable.G54.X=5", "--set", "IsoCoordinateTable.G54.Y=5", "--set",
                 "IsoCoordinateTable.G54.Z=-110"]
WIDE, NARROW = (1280, 800), (390, 844)

# How many pixels of a canvas differ from the colour of its corner.
DRAWN = """
const from = document.getElementById(arguments[0]), to = document.createElement('canvas');
to.width = from.width; to.height = from.height;
const context = to.getContext('2d');
isogloss.stage.render();
context.drawImage(from, 0, 0);
const p = new Uint32Array(context.getImageData(0, 0, to.width, to.height).data.buffer);
return p.reduce((sum, value) => sum + (value !== p[0]), 0);
"""
# The path and what lies above it, small, as base64 of PNG.
SMALL = """
const to = document.createElement('canvas');
to.width = 320; to.height = 256;
const context = to.getContext('2d');
isogloss.stage.render();
for (const id of ['canvas', 'above']) context.drawImage(document.getElementById(id), 0, 0, 320, 256);
return to.toDataURL('image/png').split(',')[1];
"""
# The mean difference of two such pictures, 0 to 255.
COMPARE = """
const pixels = async (text) => {
  const image = new Image();
  image.src = `data:image/png;base64,${text}`;
  await image.decode();
  const to = document.createElement('canvas');
  to.width = 320; to.height = 256;
  const context = to.getContext('2d');
  context.drawImage(image, 0, 0);
  return context.getImageData(0, 0, 320, 256).data;
};
const [a, b] = [await pixels(arguments[0]), await pixels(arguments[1])];
return a.reduce((sum, value, i) => sum + Math.abs(value - b[i]), 0) / a.length;
"""


def make_page(folder, name, *arguments):
    file = pathlib.Path(folder, name)
    done = subprocess.run([ARGUMENTS.isogloss, "view", *map(str, arguments), "-o", file], capture_output=True, timeout=120)
    if not file.exists():
        raise AssertionError(done.stderr.decode(errors="replace"))
    return file.as_uri()


class PageCase(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.browser = cls.enterClassContext(browser.Browser(*WIDE))
        cls.part = make_page(cls.folder.name, "part.html", PART, *TOOLS)

    def open(self, address, size=WIDE):
        self.browser.resize(*size)
        self.browser.open(address)
        self.assertEqual(self.browser.run("return document.body.dataset.state"), "ready")

    def tearDown(self):
        self.keep(self.id().split(".")[-1])
        # A picture that is read back makes the driver speak of a stall: that is this test.
        errors = [e for e in self.browser.errors() if "GPU stall due to ReadPixels" not in e]
        self.assertEqual(errors, [])

    def keep(self, name):
        if ARGUMENTS.pictures:
            self.browser.picture(pathlib.Path(ARGUMENTS.pictures, name + ".png"))

    def drawn(self, canvas="canvas"):
        return self.browser.run(DRAWN, canvas)

    def text(self, selector):
        return self.browser.run("return document.querySelector(arguments[0]).textContent", selector)

    def chosen(self):
        return self.browser.run("return Number(document.querySelector('.line.chosen')?.dataset.line ?? 0)")

    def set_time(self, seconds):
        self.browser.run("const s = document.getElementById('slider'); s.value = arguments[0];"
                         "s.dispatchEvent(new Event('input'))", seconds)


class Part(PageCase):
    def test_it_opens_at_both_widths(self):
        for size in (WIDE, NARROW):
            with self.subTest(size):
                self.open(self.part, size)
                self.assertGreater(self.drawn(), 2000)
                self.assertGreater(self.drawn("above"), 100)  # the tool
                wide = self.browser.run("return document.documentElement.scrollWidth")
                self.assertLessEqual(wide, size[0])
                self.keep(f"part-{size[0]}")
        self.browser.prefer("dark")
        self.open(self.part)
        self.keep("part-dark")
        self.browser.prefer("light")

    def test_a_click_on_a_line_lights_its_moves_up(self):
        for size in (WIDE, NARROW):
            with self.subTest(size):
                self.open(self.part, size)
                before = self.drawn("above")
                self.browser.click('.line[data-line="10"]')
                self.browser.wait("return document.getElementById('explanation').textContent.includes('900')")
                self.assertEqual(self.chosen(), 10)
                self.assertGreater(self.drawn("above"), before + 100)
                self.keep(f"line-{size[0]}")

    def test_a_click_on_a_move_shows_its_line(self):
        for size in (WIDE, NARROW):
            with self.subTest(size):
                self.open(self.part, size)
                line = 12
                x, y = self.browser.run("""
                    const path = isogloss.paths[0], move = path.line.indexOf(arguments[0]);
                    const box = document.getElementById('canvas').getBoundingClientRect();
                    const [x, y] = isogloss.stage.spotOf(0, move);
                    return [box.x + x, box.y + y];""", line)
                self.browser.click_at(x, y)
                self.browser.wait("return document.getElementById('explanation').textContent !== ''")
                self.assertEqual(self.chosen(), line)

    def test_the_slider_moves_the_tool(self):
        self.open(self.part)
        total = self.browser.run("return isogloss.timeline.total")
        self.set_time(0)
        begin, at_begin = self.text("#readout"), self.browser.run(SMALL)
        self.set_time(total * 0.4)
        middle, at_middle = self.text("#readout"), self.browser.run(SMALL)
        self.assertNotEqual(begin, middle)
        self.assertNotEqual(at_begin, at_middle)
        self.keep("slider")
        # Half-way along a straight feed the tip is half-way.
        self.set_time(self.browser.run("""
            const path = isogloss.paths[0], move = path.line.indexOf(12);
            return (path.begin[move] + path.begin[move + 1]) / 2;"""))
        self.assertRegex(self.text("#readout"), r"X +70\.000 +Y +0\.000 +Z +-3\.000")
        self.assertIn("F 900 mm/min, line 12", self.text("#readout"))

    def test_playing_goes_on_with_the_feed(self):
        self.open(self.part)
        self.browser.run("document.getElementById('speed').value = 1000")
        self.browser.click("#play")
        self.browser.wait("return !isogloss.timeline.isPlaying && isogloss.timeline.time === isogloss.timeline.total")

    def test_what_is_done_bit_by_bit_looks_as_what_is_drawn_at_once(self):
        self.open(self.part)
        self.browser.run("isogloss.timeline.set(0); isogloss.stage.render();")
        for part in (0.1, 0.3, 0.5, 0.8, 1):
            self.browser.run("isogloss.timeline.set(arguments[0] * isogloss.timeline.total); isogloss.stage.render()", part)
        pieces = self.browser.run(SMALL)
        self.browser.run("isogloss.stage.request('all'); isogloss.stage.render()")
        self.assertLess(self.browser.run(COMPARE, pieces, self.browser.run(SMALL)), 0.6)

    def test_search_finds_lines(self):
        self.open(self.part)
        self.browser.type("#search", "g03 i-20")
        self.assertEqual(self.text("#found"), "3")
        self.browser.type("#search", "\ue007")
        self.assertEqual((self.text("#found"), self.chosen()), ("1/3", 22))
        self.browser.click("#found-next")
        self.assertEqual((self.text("#found"), self.chosen()), ("2/3", 23))
        self.assertIn("G03 I-20", self.text(".line.chosen mark"))

    def test_tools_and_rapids_are_shown_and_hidden(self):
        self.open(self.part)
        self.browser.click('[data-tab="tools"]')
        self.assertIn("T1 END MILL <12>", self.text("#tools"))
        counts = [self.drawn()]
        self.browser.click("#rapids")
        counts.append(self.drawn())
        self.browser.click("#tools li:nth-child(2) input")
        counts.append(self.drawn())
        self.assertGreater(counts[0], counts[1])
        self.assertGreater(counts[1], counts[2])
        self.browser.click("#rapids")
        self.browser.click("#tools li:nth-child(2) input")
        self.assertEqual(self.drawn(), counts[0])

    def test_diagnostics_stand_at_their_lines_and_in_a_list(self):
        self.open(self.part)
        self.browser.click('[data-tab="reports"]')
        self.assertIn("[ISO-0285]", self.text("#reports"))
        self.browser.click('#reports li[data-line="31"]')
        self.assertEqual(self.chosen(), 31)
        self.assertIn("warning", self.browser.run("return document.querySelector('.line.chosen .sign').className"))
        self.browser.wait("return document.querySelector('#explanation .report') !== null")

    def test_text_of_a_program_does_nothing(self):
        self.open(self.part)
        self.assertTrue(self.browser.run("return !('hacked' in window) && !('HACKED' in window)"))
        self.assertIn("(</SCRIPT><SCRIPT>WINDOW.HACKED=1</SCRIPT><!-- &AMP;", self.text('.line[data-line="3"] .text'))

    def test_the_picture_equals_the_reference(self):
        self.open(self.part)
        made, file = self.browser.run(SMALL), HERE / "part.png"
        if ARGUMENTS.update:
            file.write_bytes(base64.b64decode(made))
        reference = base64.b64encode(file.read_bytes()).decode()
        self.assertLess(self.browser.run(COMPARE, made, reference), 1.5)
        self.browser.click('[data-camera="top"]')
        self.assertGreater(self.browser.run(COMPARE, self.browser.run(SMALL), reference), 2.5)


class FiveAxes(PageCase):
    def test_tables_turn_the_part_below_a_tool_that_stands_upright(self):
        address = make_page(self.folder.name, "faces.html", FACES, *FACES_OPTIONS)
        self.open(address)
        self.browser.click('[data-tab="tools"]')
        self.assertIn("table A, table C", self.text("#kinematics"))
        self.keep("faces-rests")
        self.browser.click("#turning")
        run = subprocess.run([ARGUMENTS.isogloss, "run", FACES, *map(str, FACES_OPTIONS)], capture_output=True, timeout=60)
        motions = [json.loads(line) for line in run.stdout.splitlines()]
        moves = [m for m in motions if m["Event"] in ("rapid", "feed", "arc", "dwell")]
        # In the machine the tip stands below the gauge point by the length of the tool, wherever the tables are.
        tips = self.browser.run("""
            const { stage, paths: [path], timeline } = isogloss, out = [];
            for (let i = 0; i < path.moves; ++i) {
              timeline.set(path.begin[i + 1] - 1e-9);
              const { part, place } = stage.paths[0], point = stage.tipInMachine(0);
              out.push([...point, ...stage.toolInMachine(0)]);
            }
            return out;""")
        self.assertEqual(len(tips), len(moves))
        checked = 0
        for tip, move in zip(tips, moves):
            if move["Event"] == "dwell" or not all(a in move.get("MachineCoordinate", {}) for a in "XYZ"):
                continue
            machine = [move["MachineCoordinate"][a] for a in "XYZ"]
            self.assertAlmostEqual(tip[0], machine[0], places=2, msg=str(move))
            self.assertAlmostEqual(tip[1], machine[1], places=2, msg=str(move))
            self.assertIn(round(machine[2] - tip[2], 2), (0, 95.5, 143.25), msg=str(move))
            self.assertAlmostEqual(tip[5], 1, places=3, msg=str(move))
            checked += 1
        self.assertGreater(checked, 30)
        self.browser.run("isogloss.timeline.set(isogloss.timeline.total * 0.62)")
        self.keep("faces-turned")

    def test_rotary_axes_without_kinematics_are_said_to_be_numbers(self):
        program = pathlib.Path(self.folder.name, "rotary.nc")
        program.write_text("G90 G54 G21\nG0 X0 Y0 Z5. A0\nG1 Z-1. F100\nG1 X50. A90.\nM30\n")
        self.open(make_page(self.folder.name, "rotary.html", program, "-d", "fanuc"))
        self.browser.click('[data-tab="tools"]')
        self.assertIn("has no MachineKinematics", self.text("#kinematics"))
        self.assertIn("A   90.00", self.text("#readout"))


class TwoSides(PageCase):
    def test_differences_are_marked_on_both_sides(self):
        program = pathlib.Path(self.folder.name, "two.nc")
        program.write_text("G90 G17 G54 G21\nT1 M6\nG0 X0 Y0 Z5.\nG1 Z-1. F100\nX10\nY20.\nX-20.\nM30\n")
        self.open(make_page(self.folder.name, "two.html", program, "-a", "fanuc", "-b", "iso"))
        names = self.browser.run("return [...document.querySelectorAll('#names b')].map((b) => b.textContent)")
        self.assertEqual(names, ["fanuc", "iso"])
        self.browser.click('[data-tab="differences"]')
        self.assertIn("line 5", self.text("#differences"))
        self.keep("two-differences")
        self.browser.click('#differences li[data-line="5"]')
        self.assertIn("apart", self.browser.run("return document.querySelector('.line.chosen .sign').className"))
        self.browser.wait("return document.querySelectorAll('#explanation p').length > 1")


class Live(PageCase):
    def test_a_served_page_explains_on_demand_and_reloads(self):
        program = pathlib.Path(self.folder.name, "live.nc")
        program.write_bytes(PART.read_bytes())
        with Served(program, *TOOLS, "--explain-lines", "1") as served:
            self.open(served.address)
            self.browser.click('.line[data-line="10"]')
            self.browser.wait("return document.getElementById('explanation').textContent.includes('900')")
            moves = self.browser.run("return isogloss.paths[0].moves")
            program.write_bytes(PART.read_bytes().replace(b"G00 Z10.\n", b"G00 Z10.\nG00 X5.\n", 1))
            self.browser.wait(f"return document.body.dataset.state === 'ready' && isogloss.paths[0].moves === {moves + 1}")
            self.assertEqual(self.text("#served"), "live")
            self.browser.ask("POST", "/url", {"url": "about:blank"})  # it would go on asking


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--isogloss", required=True)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--pictures")
    ARGUMENTS, rest = parser.parse_known_args()
    page_test.ARGUMENTS = ARGUMENTS
    if missing := browser.missing():
        print(f"skipped: {missing} not installed", file=sys.stderr)
        sys.exit(77)
    unittest.main(argv=[sys.argv[0], *rest])
