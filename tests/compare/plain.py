"""Seeded random programs in the language that a Fanuc and LinuxCNC share."""
import math
import random
import re

PLANE_OF = {"G17": (0, 1, 2), "G18": (2, 0, 1), "G19": (1, 2, 0)}
TOOLS = 6
RENAMED = re.compile(r"G0?4(?!\d)|G73|G8\d|L10")  # what linuxcnc.translated() writes in another way
CYCLES = ("G81", "G82", "G83", "G73", "G85")  # that the dialect fanuc carries out, and LinuxCNC in the same steps


def tool_length(tool):
    """mm; a whole number of tenths of an inch, so that neither side has to round."""
    return 50.8 + 12.7 * tool


class PlainProgram:
    """Keeps the tool position in program coordinates, axis by axis; None: unknown."""

    def __init__(self, seed, fragments=60, cycles=CYCLES):
        self.cycles = cycles
        self.random = random.Random(seed)
        self.lines = []
        self.at = [None] * 3
        self.inch = False
        self.plane = "G17"
        self.incremental = False
        self.group01 = None
        self.feed = None
        self.inverse = False  # G93
        self.angles = [0.0] * 3  # of A, B and C
        self.tool_length = 0  # H in force
        self.is_local = self.is_shifted = False  # by G52, by G92
        self.start()
        kinds = [(12, self.straight), (8, self.arc_by_centre), (6, self.arc_by_radius), (2, self.full_circle),
                 (2, self.change_distance), (3, self.change_plane), (1, self.change_unit), (2, self.change_work_offset),
                 (1, self.set_work_offset), (2, self.change_tool_length), (1, self.go_by_machine),
                 (1, self.go_home), (1, self.dwell), (1, self.shift_local), (1, self.set_position), (2, self.drill), (1, self.change_tool),
                 (2, self.turn), (1, self.inverse_time), (1, self.path_mode), (1, self.move_to_work_offset),
                 (1, self.set_tool_length)]
        weights, steps = [w for w, _ in kinds], [s for _, s in kinds]
        for step in self.random.choices(steps, weights, k=fragments):
            step()
        self.end_shift()
        self.shift_local(cancel=True)
        self.write("M30")

    # -- words

    def write(self, *words):
        sep = "" if self.random.random() < 0.1 else " "
        text = sep.join(w for w in words if w)
        if self.random.random() < 0.04 and not RENAMED.search(text):
            text = text.lower()
        if self.random.random() < 0.05:
            text += " (CHECK)"
        self.lines.append(text)

    def number(self, value, decimals=None):
        digits = decimals if decimals is not None else (4 if self.inch else 3)
        text = f"{value:.{digits}f}"
        text = text.rstrip("0") if self.random.random() < 0.95 else text
        if float(text) == 0:
            return "0."
        form = self.random.random()
        if form < 0.03 and value > 0:
            return "+" + text
        return text.replace("0.", ".", 1) if form < 0.1 and abs(float(text)) < 1 else text

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
        if self.inverse:
            return "F" + self.number(self.random.uniform(0.5, 90))
        if self.feed and self.random.random() < 0.8:
            return ""
        self.feed = self.random.randrange(2, 40) if self.inch else self.random.randrange(50, 2000, 10)
        return f"F{self.feed}" + ("." if self.inch else "")

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
                    self.at[axis] = round(self.at[axis] + delta, 9)
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
            words.append(self.axis_word(axis, target, round(target - self.at[axis], 9), 9 if self.incremental else decimals))
        if self.random.random() < 0.3:  # helix
            self.known([third])
            delta = self.length(-5, 5)
            words.append(self.axis_word(third, self.at[third] + delta, delta, 9))
            self.at[third] = round(self.at[third] + delta, 9)
        self.random.shuffle(words)
        self.at[first], self.at[second] = end
        return words

    def arc(self, sweep):
        """Start to a random centre: decimals, centre's increments, end; radius as it comes out after rounding."""
        first, second, third = PLANE_OF[self.plane]
        self.known([first, second, third])
        decimals = self.random.choice((5 if self.inch else 4, 9))
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
            words = ["XYZ"[a] + self.number(self.at[a], 9) for a in (first, second)]
        if self.random.random() < 0.3:
            delta = self.length(-3, 3)
            words.append(self.axis_word(third, self.at[third] + delta, delta, 9))
            self.at[third] = round(self.at[third] + delta, 9)
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

    def move_to_work_offset(self):
        """The work offset, and now and then the distance mode, change in the block of the move."""
        distance = ""
        if self.incremental or self.random.random() < 0.3:
            self.known([2])
            self.incremental = not self.incremental
            distance = "G91" if self.incremental else "G90"
        offset = f"G{self.random.randrange(54, 60)}" if not self.incremental else ""
        motion = self.motion(0)
        values = [self.length(-20, 20) for _ in range(3)]
        if self.incremental:
            self.at = [None if at is None else round(at + v, 9) for at, v in zip(self.at, values)]
        else:
            self.at = list(values)
        words = [distance, offset, motion, *("XYZ"[i] + self.number(v) for i, v in enumerate(values))]
        self.random.shuffle(words)
        self.write(*words)

    def turn(self):
        """Rotary axes, less than half a turn: the way of a Fanuc is the shorter one. By feed they turn alone: with X, Y or Z
        in the block F counts other axes there, and other units in inches."""
        self.known(range(3))
        axes = self.random.sample(range(3), self.random.randrange(1, 4))
        words = []
        for axis in axes:
            delta = round(self.random.uniform(-170, 170), 3)
            self.angles[axis] = round(self.angles[axis] + delta, 3)
            words.append("ABC"[axis] + self.number(delta if self.incremental else self.angles[axis], 3))
        if self.inch or self.random.random() < 0.5:
            if not self.incremental and self.random.random() < 0.5:
                self.at[0] = self.length(-60, 60)
                words.insert(0, "X" + self.number(self.at[0]))
            self.write(self.motion(0), *words)
        else:
            self.write(self.motion(1), *words, self.feed_word())

    def inverse_time(self):
        """G93: F is the inverse of the minutes of its block, and stands in each that cuts. No arcs: see
        tests/differences.md."""
        self.known(range(3))
        self.write("G93")
        self.inverse = True
        for _ in range(self.random.randrange(1, 5)):
            self.straight()
        self.feed, self.inverse = None, False
        self.write("G94")

    def path_mode(self):
        self.write(self.random.choice(("G61", "G64")))

    def set_tool_length(self):
        """Of a tool whose length is not in force: what a change of that one does is a parameter of a Fanuc."""
        if self.incremental:
            self.change_distance()
        tool = self.random.choice([t for t in range(1, TOOLS + 1) if t != self.tool_length])
        self.write("G10", "L10", f"P{tool}", "R" + self.number(self.hundredth(0, 900)))

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
        self.write(self.random.choice(("G28", "G28", "G30")), *("XYZ"[a] + ("0." if incremental else self.number(self.length(-20, 60))) for a in axes))
        for axis in axes:
            self.at[axis] = None

    def dwell(self):
        self.write("G4", f"P{self.random.randrange(50, 3000, 50)}")

    def hundredth(self, low, high):
        """A random multiple of a hundredth of an inch, in the active unit."""
        inch_hundredths = round(self.random.uniform(low, high))
        return inch_hundredths * 0.01 if self.inch else round(inch_hundredths * 0.254, 3)

    def end_shift(self):
        if self.is_shifted:
            self.write("G92.1")
            self.at = [None] * 3
        self.is_shifted = False

    def set_position(self):
        """G92 at a place that needs no rounding; one offset with G52 there, two here: see tests/differences.md."""
        if self.is_local:
            self.shift_local(cancel=True)
        if self.incremental:
            self.change_distance()
        self.at = [self.hundredth(-200, 200) for _ in range(3)]
        self.write(self.motion(0), *("XYZ"[i] + self.number(v) for i, v in enumerate(self.at)))
        words = []
        for axis in self.random.sample(range(3), self.random.randrange(1, 4)):
            self.at[axis] = self.hundredth(-300, 300)
            words.append("XYZ"[axis] + self.number(self.at[axis]))
        if self.random.random() < 0.5:
            self.write("G92", *words)
        else:
            for word in words:
                self.write("G92", word)
        self.is_shifted = True

    def shift_local(self, cancel=False):
        if self.incremental:
            self.change_distance()
        self.end_shift()
        axes = self.random.sample("XYZ", self.random.randrange(1, 4))
        self.is_local = not (cancel or self.random.random() < 0.4)
        if not self.is_local:
            self.write("G52", "X0.", "Y0.", "Z0.")
        else:
            hundredths = [round(self.random.uniform(-500, 500)) for _ in axes]
            self.write("G52", *(a + self.number(h * 0.01 if self.inch else h * 0.254)
                                for a, h in zip(axes, hundredths)))
        self.at = [None] * 3

    def drill(self):
        """One run of holes, all under G98 or all under G99, R below the initial level."""
        if self.plane != "G17" and self.random.random() < 0.6:
            self.plane = "G17"
            self.write("G17")
        self.place()
        first, second, third = PLANE_OF[self.plane]
        self.across, self.along = "XYZ"[first] + "XYZ"[second], "XYZ"[third]
        level = self.at[third]
        self.feed = None
        self.level = self.random.choice(("G98", "G99"))
        if self.random.random() < 0.3:
            self.change_distance()
            r = -abs(self.length(1, 20))
            depth = -abs(self.length(2, 20))
            self.write(self.level, *self.cycle_words(self.random.choice(self.cycles), -depth),
                       *(a + self.number(self.length(1, 9)) for a in self.across), self.along + self.number(depth), "R" + self.number(r), self.feed_word(),
                       f"K{self.random.randrange(2, 6)}")
        else:
            self.holes(level)
        self.write("G80")
        self.group01 = None
        self.at = [None] * 3
        self.place()

    def holes(self, level):
        """A modal chain: other cycles with all their words, new levels, and blocks that do not drill. R only falls,
        since LinuxCNC goes up to a higher R before it goes sideways, and what depends on Q is written with it."""
        r = round(level - abs(self.length(1, 9)), 4)
        for number in range(self.random.randrange(1, 7)):
            if number == 0 or self.random.random() < 0.2:
                cycle = self.random.choice(self.cycles)
                bottom = round(r - abs(self.length(2, 20)), 4)
                self.write(self.level if number == 0 else "", *self.cycle_words(cycle, r - bottom),
                           *self.hole_words(self.across), self.along + self.number(bottom), "R" + self.number(r), self.feed_word())
            elif self.random.random() < 0.2 and cycle not in ("G73", "G83"):
                self.write(*self.hole_words(self.random.choice((self.across[0], self.across))),
                           self.along + self.number(r - abs(self.length(2, 20))))
            else:
                self.write(*self.hole_words(self.random.choice((*self.across, self.across))), self.feed_word())
            if self.random.random() < 0.2:
                self.write(self.random.choice(("M8", "M9", "F150.", "G4 P200")))
            if self.random.random() < 0.3 and cycle not in ("G73", "G83"):
                r = round(r - abs(self.length(0.1, 1)), 4)
                self.write(*self.hole_words(self.across[0]), "R" + self.number(r),
                           self.along + self.number(r - abs(self.length(2, 20))))

    def hole_words(self, axes):
        return [a + self.number(self.length(-60, 60)) for a in axes]

    def cycle_words(self, cycle, depth):
        """The code with P or Q. No depth of a whole number of Q: LinuxCNC adds up doubles and may peck once more."""
        if cycle == "G82":
            return cycle, f"P{self.random.randrange(50, 1000, 50)}"
        if cycle in ("G73", "G83"):
            pecks = self.random.randrange(0, 7) + self.random.uniform(0.1, 0.9)
            return cycle, "Q" + self.number(depth / pecks)
        return (cycle,)


def program(seed, cycles=CYCLES):
    return "\n".join(PlainProgram(seed, cycles=cycles).lines) + "\n"
