"""Seeded random programs of canned cycles, of which a model knows for certain what a machine does.

Every block is tried on the model; one that it calls uncertain is left out. Decimal points are always written."""
import copy
import random

from machine import AXIS, PLANES, Machine, Uncertain

NEED_Q = (73, 76, 83, 87)
TURNING = {74: "M04", 84: "M03", 76: "M03", 86: "M03", 87: "M03", 88: "M03"}


class RandomProgram:
    def __init__(self, seed, model=Machine, cycles=None, blocks=40):
        self.random = random.Random(seed)
        self.model = model()
        self.cycles = [c for c in model.CYCLES if cycles is None or c in cycles]
        self.machine_levels = model.MACHINE_LEVELS  # of G87
        self.lines = []
        self.start()
        while len(self.lines) < blocks:
            self.next_block()
        self.attempt("G80")
        self.attempt("M30")

    @property
    def text(self):
        return "\n".join(self.lines) + "\n"

    def attempt(self, *words):
        """Writes the block if the model is sure of it."""
        row = " ".join(w for w in words if w)
        before = copy.deepcopy({k: v for k, v in vars(self.model).items() if k != "events"})
        known = len(self.model.events)
        try:
            self.model.run_block(row)
        except Uncertain:
            vars(self.model).update(before)
            del self.model.events[known:]
            return False
        self.lines.append(row)
        return True

    # -- words

    def chance(self, probability):
        return self.random.random() < probability

    def number(self, mm):
        """In the unit in force."""
        text = f"{float(mm / self.model.unit):.{3 if self.model.unit == 1 else 4}f}".rstrip("0")
        return "0." if text == "-0." else text

    def between(self, low, high):
        """Now and then whole where that is not 0, which makes exact multiples and equal levels likely."""
        value = self.random.uniform(low, high)
        return round(value) if self.chance(0.3) and round(value) else round(value, 3)

    def place(self, axis, low=-60, high=60):
        """A word for a position, under G91 a step."""
        value = self.between(-20, 20) if self.model.incremental else self.between(low, high)
        return axis + self.number(value)

    def feed_word(self):
        if self.model.feed is not None and self.chance(0.7):
            return ""
        return "F" + (self.number(self.between(0.05, 3)) if self.model.per_revolution
                      else str(self.random.randrange(20, 900, 5) // (1 if self.model.unit == 1 else 20)))

    def dwell_word(self):
        p = self.random.randrange(0, 2000, 50)
        return f"P{p}" if self.machine_levels else f"P{p / 1000:g}"

    # -- blocks

    def start(self):
        self.attempt("G21 G17 G90 G94 G40 G49 G80")
        self.attempt("G00", *(a + self.number(self.between(-30, 60)) for a in "XYZ"))
        self.attempt("M03", f"S{self.random.randrange(100, 3000, 50)}")

    def next_block(self):
        if self.model.cycle is None:
            kinds = [(10, self.enter_cycle), (3, self.move), (2, self.plane), (2, self.distance), (1, self.feed_mode),
                     (0.5, self.unit), (2, self.between_holes)]
        else:
            kinds = [(10, self.hole), (3, self.enter_cycle), (4, self.between_holes), (1, self.distance),
                     (2, self.leave_cycle)]
        self.random.choices([k for _, k in kinds], [w for w, _ in kinds])[0]()

    def move(self):
        code = self.random.choice(("G00", "G01", "", ""))
        axes = self.random.sample("XYZ", self.random.randrange(1, 4))
        self.attempt(code, *(self.place(a) for a in axes), self.feed_word())

    def plane(self):
        self.attempt(self.random.choice(("G17", "G18", "G19")))

    def distance(self):
        self.attempt(self.random.choice(("G90", "G91")))

    def unit(self):
        self.attempt(self.random.choice(("G20", "G21")))

    def feed_mode(self):
        code, feed = ("G95", self.number(self.between(0.05, 3))) if self.chance(0.4) else ("G94", "40")
        self.attempt(code, f"F{feed}")

    def between_holes(self):
        """A block that does not drill, whether a cycle is on or not."""
        speed = f"S{self.random.randrange(100, 3000, 50)}"
        dwell = self.random.choice(("X1.5", "X0.25", self.dwell_word()))
        self.attempt(*self.random.choice((("M08",), ("M09",), ("M03", speed), ("M04", speed), (speed,), ("M05",),
                                          ("M00",), ("T5",), ("G04", dwell), (self.feed_word(),), ("G98",), ("G99",),
                                          ("(CHECK)",), (self.random.choice(("Q3.", self.dwell_word())),)
                                          if self.model.cycle and self.chance(0.3) else ("M08", "M09")[:1])))

    def leave_cycle(self):
        first = self.random.choice("XYZ")
        self.attempt(*self.random.choice((("G80",), ("G80", self.place(first)), ("G00", self.place(first)),
                                          ("G01", self.place(first), self.feed_word()))))

    def levels(self, code):
        """Words of R and the bottom; the depth from R."""
        axis = PLANES[self.model.plane][2]
        now = self.model.at[AXIS[axis]]
        initial = self.model.entry_level if self.model.cycle and self.machine_levels else now
        if code == 87 and self.machine_levels:
            bottom = initial - self.between(1, 30)
            r = bottom - self.between(1, 30)
        else:
            r = initial - (self.between(-15, -0.5) if self.chance(0.1) else self.between(0.5, 40))
            bottom = r - self.between(0.5, 30)
        r_word, z_word = (r - initial, bottom - r) if self.model.incremental else (r, bottom)
        return ["R" + self.number(r_word), axis + self.number(z_word)], abs(r - bottom)

    def q_word(self, code, depth):
        if code in (76, 87):
            return "Q" + self.number(self.random.choice((-1, 1, 1, 1)) * self.between(0.1, 5)
                                     if self.machine_levels else self.between(0.1, 5))
        pecks = self.random.choice((0.5, 1, 2, 3, 4, 5, 7, 9, 12))
        q = depth / pecks if self.chance(0.5) else depth / self.random.uniform(0.5, 15)
        return "Q" + self.number(max(float(q), 0.05))

    def hole_words(self):
        first, second, _ = PLANES[self.model.plane]
        axes = self.random.choice((first, second, first + second, first + second))
        return [self.place(a) for a in axes]

    def repeats(self):
        if self.chance(0.88):
            return ""
        return self.random.choice("KKKL") + str(self.random.choice((0, 1, 2, 3, 5)))

    def enter_cycle(self):
        code = self.random.choice(self.cycles)
        if code in (74, 84) and self.chance(0.5) and self.model.cycle is None and self.machine_levels:
            if self.attempt("M29", f"S{self.random.randrange(100, 900, 50)}"):
                for _ in range(5):
                    if self.cycle_block(code):
                        break
                for _ in range(self.random.randrange(4)):
                    self.hole()
                self.attempt("G80")
                self.attempt("M03", "S500")
            return
        if code in TURNING and self.chance(0.7):
            self.attempt(TURNING[code], f"S{self.random.randrange(100, 3000, 50)}")
        self.cycle_block(code)

    def cycle_block(self, code):
        level = self.random.choice(("G98", "G99", ""))
        if code == 87 and self.machine_levels:
            level = "G98"
        words, depth = self.levels(code)
        same_levels = self.model.cycle not in (None, 87) and code != 87 and self.chance(0.4)
        words = self.hole_words() + ([] if same_levels else words)
        if self.model.rigid and self.chance(0.5):
            words.append(self.q_word(83, depth))
        if code in NEED_Q and (self.chance(0.9) or self.model.peck is None):
            words.append(self.q_word(code, depth))
        if self.chance(0.6):
            words.append(self.dwell_word())
        words += [w for w in (self.feed_word(), self.repeats()) if w]
        self.random.shuffle(words)
        return self.attempt(level, self.random.choice(("", "", "", "G90", "G91")) if same_levels else "", f"G{code}",
                            *words)

    def hole(self):
        """A block in a cycle that drills."""
        words = self.hole_words()
        code = self.model.cycle
        new_levels, depth = self.levels(code)
        if self.chance(0.25):
            words += new_levels
        elif self.chance(0.1) and code != 87:
            words += new_levels[self.random.randrange(2):][:1]
        if self.chance(0.1):
            words = words[-1:]
        if code in NEED_Q and self.chance(0.15):
            words.append(self.q_word(code, depth))
        if self.chance(0.15):
            words.append(self.dwell_word())
        if self.chance(0.1):
            words.append(self.random.choice(("M08", "M09")))
        words += [w for w in (self.feed_word(), self.repeats()) if w]
        self.random.shuffle(words)
        level = self.random.choice(("G98", "G99")) if self.chance(0.15) else ""
        self.attempt(level, *words)
