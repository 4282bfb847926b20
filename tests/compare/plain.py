"""Seeded random programs in the language that a Fanuc and LinuxCNC share."""
import math
import random

PLANE_OF = {"G17": (0, 1, 2), "G18": (2, 0, 1), "G19": (1, 2, 0)}
TOOLS = 6


def tool_length(tool):
    """mm; a whole number of tenths of an inch, so that neither side has to round."""
    return 50.8 + 12.7 * tool


class PlainProgram:
    """Knows where the tool is in program coordinates, axis by axis, or that it does not (None)."""

    def __init__(self, seed, fragments=60):
        self.random = random.Random(seed)
        self.lines = []
        self.at = [None] * 3
        self.inch = False
        self.plane = "G17"
        self.incremental = False
        self.group01 = None
        self.feed = None
        self.tool_length = 0  # H in force
        self.start()
        kinds = [(12, self.straight), (8, self.arc_by_centre), (6, self.arc_by_radius), (2, self.full_circle),
                 (2, self.change_distance), (3, self.change_plane), (1, self.change_unit), (2, self.change_work_offset),
                 (1, self.set_work_offset), (2, self.change_tool_length), (1, self.go_by_machine),
                 (1, self.go_home), (1, self.dwell), (1, self.shift_local), (2, self.drill), (1, self.change_tool)]
        weights, steps = [w for w, _ in kinds], [s for _, s in kinds]
        for step in self.random.choices(steps, weights, k=fragments):
            step()
        self.shift_local(cancel=True)
        self.write("M30")

    # -- words

    def write(self, *words):
        sep = "" if self.random.random() < 0.1 else " "
        text = sep.join(w for w in words if w)
        if self.random.random() < 0.05:
            text += " (CHECK)"
        self.lines.append(text)

    def number(self, value, decimals=None):
        digits = decimals if decimals is not None else (4 if self.inch else 3)
        text = f"{value:.{digits}f}".rstrip("0")
        return text if text != "-0." else "0."

    def length(self, low, high):
        """A random length, rounded as it will be written, in the active unit."""
        return round(self.random.uniform(low, high) / (25.4 if self.inch else 1), 4 if self.inch else 3)

    def motion(self, code):
        """The group 01 word, left out now and then where it is modal."""
        if self.group01 == code and self.random.random() < 0.7:
            return ""
        self.group01 = code
        return self.random.choice((f"G{code}", f"G0{code}"))

    def feed_word(self):
        if self.feed and self.random.random() < 0.8:
            return ""
        self.feed = self.random.randrange(2, 40) if self.inch else self.random.randrange(50, 2000, 10)
        return f"F{self.feed}"

    def axis_word(self, axis, target, delta, decimals=None):
        value = delta if self.incremental else target
        return "XYZ"[axis] + self.number(value, decimals)

    # -- fragments

    def start(self):
        self.write("G21 G17 G90 G94 G40 G49 G80")
        for offset in range(1, 7):
            words = [a + self.number(round(self.random.uniform(-1500, 0)) * 0.254) for a in "XYZ"]
            self.write("G10", "L2", f"P{offset}", *words)
        self.write("G54")
        self.write("T1", "M6")
        self.place()

    def place(self):
        """An absolute rapid after which every axis is known."""
        if self.incremental:
            self.change_distance()
        self.at = [self.length(-60, 60), self.length(-60, 60), self.length(-60, 60)]
        word = self.motion(0)
        self.write(word, *("XYZ"[i] + self.number(v) for i, v in enumerate(self.at)))

    def known(self, axes):
        if any(self.at[a] is None for a in axes):
            self.place()

    def straight(self):
        axes = self.random.sample(range(3), self.random.randrange(1, 4))
        words = []
        for axis in axes:
            if self.incremental:
                delta = self.length(-20, 20)
                words.append("XYZ"[axis] + self.number(delta))
                if self.at[axis] is not None:
                    self.at[axis] = round(self.at[axis] + delta, 6)
            else:
                self.at[axis] = self.length(-60, 60)
                words.append("XYZ"[axis] + self.number(self.at[axis]))
        if self.random.random() < 0.4:
            self.write(self.motion(0), *words)
        else:
            self.write(self.motion(1), *words, self.feed_word())

    def arc_words(self, end, decimals):
        first, second, third = PLANE_OF[self.plane]
        words = []
        for axis, target in ((first, end[0]), (second, end[1])):
            words.append(self.axis_word(axis, target, round(target - self.at[axis], 6), decimals))
        if self.random.random() < 0.3:  # helix
            self.known([third])
            delta = self.length(-5, 5)
            words.append(self.axis_word(third, self.at[third] + delta, delta))
            self.at[third] = round(self.at[third] + delta, 6)
        self.random.shuffle(words)
        self.at[first], self.at[second] = end
        return words

    def arc(self, sweep):
        """Start to a random centre: decimals, centre's increments, end; radius as it comes out after rounding."""
        first, second, third = PLANE_OF[self.plane]
        self.known([first, second, third])
        decimals = 5 if self.inch else 4
        radius, angle = self.random.uniform(1.5, 25) / (25.4 if self.inch else 1), self.random.uniform(0, 2 * math.pi)
        i, j = round(-radius * math.cos(angle), decimals), round(-radius * math.sin(angle), decimals)
        start = self.at[first], self.at[second]
        angle = math.atan2(-j, -i) + sweep
        radius = math.hypot(i, j)
        end = (round(start[0] + i + radius * math.cos(angle), decimals),
               round(start[1] + j + radius * math.sin(angle), decimals))
        return decimals, (i, j), radius, end

    def centre_words(self, centre, decimals):
        first, second, _ = PLANE_OF[self.plane]
        words = ["IJK"[a] + self.number(c, decimals) for a, c in ((first, centre[0]), (second, centre[1])) if c != 0]
        self.random.shuffle(words)
        return words

    def arc_by_centre(self):
        ccw = self.random.random() < 0.5
        sweep = self.random.uniform(0.1, 6.1)
        decimals, centre, _, end = self.arc(sweep if ccw else -sweep)
        self.write(self.motion(3 if ccw else 2), *self.arc_words(end, decimals), *self.centre_words(centre, decimals),
                   self.feed_word())

    def arc_by_radius(self):
        ccw, long_way = self.random.random() < 0.5, self.random.random() < 0.3
        sweep = self.random.uniform(3.5, 5.8) if long_way else self.random.uniform(0.2, 2.8)
        decimals, _, radius, end = self.arc(sweep if ccw else -sweep)
        radius = round(radius, decimals)
        self.write(self.motion(3 if ccw else 2), *self.arc_words(end, decimals),
                   "R" + self.number(-radius if long_way else radius, decimals), self.feed_word())

    def full_circle(self):
        first, second, third = PLANE_OF[self.plane]
        decimals, centre, _, _ = self.arc(1.0)
        words = []
        if not self.incremental and self.random.random() < 0.5:
            words = ["XYZ"[a] + self.number(self.at[a], 6) for a in (first, second)]
        if self.random.random() < 0.3:
            delta = self.length(-3, 3)
            words.append(self.axis_word(third, self.at[third] + delta, delta))
            self.at[third] = round(self.at[third] + delta, 6)
        self.write(self.motion(self.random.choice((2, 3))), *words, *self.centre_words(centre, decimals),
                   self.feed_word())

    def change_distance(self):
        if not self.incremental:
            self.known([2])  # a new length meets an increment: see tests/differences.md
        self.incremental = not self.incremental
        self.write("G91" if self.incremental else "G90")

    def change_plane(self):
        self.plane = self.random.choice(list(PLANE_OF))
        self.write(self.plane)

    def change_unit(self):
        self.inch = not self.inch
        self.at = [None] * 3
        self.feed = None
        if self.tool_length:
            self.write("G49")  # see tests/differences.md
        self.write("G20" if self.inch else "G21")
        if self.tool_length:
            self.write(f"G43 H{self.tool_length}")
        self.place()

    def change_work_offset(self):
        self.at = [None] * 3
        self.write(f"G{self.random.randrange(54, 60)}")

    def set_work_offset(self):
        if self.incremental:
            self.change_distance()
        axes = self.random.sample("XYZ", self.random.randrange(1, 4))
        inch_hundredths = [round(self.random.uniform(-1500, 0)) for _ in axes]
        self.write("G10", "L2", f"P{self.random.randrange(1, 7)}",
                   *(a + self.number(h * 0.01 if self.inch else h * 0.254) for a, h in zip(axes, inch_hundredths)))
        self.at = [None] * 3

    def change_tool_length(self):
        if self.incremental:
            self.change_distance()
        self.at[2] = None
        self.tool_length = 0 if self.random.random() < 0.3 else self.random.randrange(1, TOOLS + 1)
        if self.tool_length == 0:
            self.write("G49")
        elif self.random.random() < 0.5:
            self.write("G43", f"H{self.tool_length}")
        else:
            self.at[2] = self.length(-60, 60)
            self.write(self.motion(0), "G43", f"H{self.tool_length}", "Z" + self.number(self.at[2]))

    def change_tool(self):
        self.known(range(3))  # rs274 alone forgets a length that no move has followed
        self.write(f"T{self.random.randrange(1, TOOLS + 1)}", self.random.choice(("M6", "M06")))

    def go_by_machine(self):
        if self.incremental:
            self.change_distance()
        axes = self.random.sample(range(3), self.random.randrange(1, 4))
        self.group01 = 0
        self.write("G53", "G0", *("XYZ"[a] + self.number(self.length(-300, 0)) for a in axes))
        for axis in axes:
            self.at[axis] = None

    def go_home(self):
        axes = self.random.sample(range(3), self.random.randrange(1, 4))
        incremental = self.random.random() < 0.7
        if incremental != self.incremental:
            self.change_distance()
        self.write("G28", *("XYZ"[a] + ("0." if incremental else self.number(self.length(-20, 60))) for a in axes))
        for axis in axes:
            self.at[axis] = None

    def dwell(self):
        self.write("G4", f"P{self.random.randrange(50, 3000, 50)}")

    def shift_local(self, cancel=False):
        if self.incremental:
            self.change_distance()
        axes = self.random.sample("XYZ", self.random.randrange(1, 4))
        if cancel or self.random.random() < 0.4:
            self.write("G52", "X0.", "Y0.", "Z0.")
        else:
            hundredths = [round(self.random.uniform(-500, 500)) for _ in axes]
            self.write("G52", *(a + self.number(h * 0.01 if self.inch else h * 0.254)
                                for a, h in zip(axes, hundredths)))
        self.at = [None] * 3

    def drill(self):
        """One run of holes, all under G98 or all under G99, R below the initial level."""
        if self.plane != "G17":
            self.plane = "G17"
            self.write("G17")
        self.place()
        z = self.at[2]
        r = round(z - abs(self.length(1, 20)), 4)
        depth = round(r - abs(self.length(2, 20)), 4)
        cycle = self.random.choice(("G81", "G82"))
        dwell = f"P{self.random.randrange(50, 1000, 50)}" if cycle == "G82" else ""
        self.feed = None
        level = self.random.choice(("G98", "G99"))
        incremental = self.random.random() < 0.3
        if incremental:
            self.change_distance()
            self.write(level, cycle, "X" + self.number(self.length(1, 9)), "Y" + self.number(self.length(1, 9)),
                       "Z" + self.number(depth - r), "R" + self.number(r - z), dwell, self.feed_word(),
                       f"K{self.random.randrange(2, 6)}")
        else:
            self.write(level, cycle, "X" + self.number(self.length(-60, 60)), "Y" + self.number(self.length(-60, 60)),
                       "Z" + self.number(depth), "R" + self.number(r), dwell, self.feed_word())
            for _ in range(self.random.randrange(0, 6)):
                self.write(self.random.choice("XY") + self.number(self.length(-60, 60)))
        self.write("G80")
        self.group01 = None
        self.at = [None] * 3
        self.place()


def program(seed):
    return "\n".join(PlainProgram(seed).lines) + "\n"
