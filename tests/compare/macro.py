"""Seeded random macro programs, written twice: in custom macro B, and in LinuxCNC's language with its O words.

Only what has the same meaning in both: variables that have a value, comparisons that are joined inside brackets, FIX,
FUP and ROUND of values that are not negative (ROUND not in words), MOD and ASIN of such values, ATAN with a first part
greater than 0. What is rounded lies beside the whole numbers that sines and cosines give: COS[90] is 0 here and 6e-17
there, of which FUP makes 0 and 1. See tests/differences.md."""
import random

FUNCTIONS = ("SIN[{}]", "COS[{}]", "SQRT[ABS[{}]]", "ABS[{}]", "FIX[ABS[{}]+0.0004]",
             "FUP[ABS[{}]+0.0004]", "LN[1+ABS[{}]]", "EXP[SIN[{}]]", "ASIN[0.9*ABS[SIN[{}]]]", "ACOS[0.9*COS[{}]]",
             "TAN[40*SIN[{}]]")
COMPARISONS = ("EQ", "NE", "GT", "GE", "LT", "LE")
VARIABLES = range(1, 8)
LONGEST = 240  # of a block; a line of LinuxCNC's holds 255 characters


class MacroProgram:
    """fanuc and linuxcnc: the two texts. A block of LinuxCNC's has the line of ours as its N."""

    def __init__(self, seed, fragments=30):
        self.random = random.Random(seed)
        self.ours, self.theirs = [], []
        self.labels = 0
        self.depth = 0  # of loops
        self.subs = [(kind, 2000 + n) for n, kind in enumerate(self.random.choices(("M98", "G65"), k=3))]
        self.block("G21 G90 G54 G17 F600.")
        for v in VARIABLES:
            self.block(f"#{v}={self.literal()}")
        for _ in range(fragments):
            self.fragment(calls=self.subs)
        self.block("M30")
        for n, (kind, number) in enumerate(self.subs):
            self.sub(kind, number, self.subs[n + 1:])
        self.theirs.append("%")

    def block(self, text, theirs=None):
        self.ours.append(text)
        self.theirs.append(theirs if theirs is not None else f"N{len(self.ours) + 1} {text}")

    @property
    def texts(self):
        return "%\n" + "\n".join(self.ours) + "\n%\n", "%\n" + "\n".join(self.theirs) + "\n"

    # -- expressions

    def literal(self):
        return f"{self.random.uniform(0, 20):.{self.random.choice((0, 1, 3))}f}"

    def variable(self):
        # Of an indirect one the number is written out: its value is another in each pass.
        v = self.random.choice(VARIABLES)
        return f"#{v}" if self.random.random() < 0.9 else f"#[{v - 1}+1]"

    def expression(self, depth=2):
        if depth == 0:
            return self.variable() if self.random.random() < 0.6 else self.literal()
        inner = lambda: self.expression(depth - self.random.randint(1, depth))
        kind = self.random.random()
        if kind < 0.45:
            parts = [inner()]
            for _ in range(self.random.randint(1, 3)):
                operator = self.random.choice("++--**/")
                parts += [operator, f"[2+ABS[{inner()}]]" if operator == "/" else inner()]
            return "".join(parts)
        if kind < 0.6:
            return f"[{inner()}]"
        if kind < 0.7:
            return f"[FIX[ABS[{inner()}]+0.0004] MOD {self.random.randint(2, 9)}]"
        if kind < 0.75:
            return f"ATAN[1+ABS[{inner()}]]/[{inner()}]"
        return self.random.choice(FUNCTIONS).format(inner())

    def length(self):
        """An expression with a value that both sides print exactly enough."""
        return self.random.choice((f"[100*SIN[{self.expression()}]]", f"[50*COS[{self.expression()}]]", self.tenths()))

    def tenths(self):
        return f"[0.1*[FIX[ABS[10*{self.expression(1)}]+0.0004] MOD 1000]]"

    def comparison(self):
        """EQ and NE of whole numbers: LinuxCNC's are equal within 0.0001."""
        comparison = self.random.choice(COMPARISONS)
        form = "[FIX[ABS[{}]+0.0004] MOD 4]" if comparison in ("EQ", "NE") else "{}"
        return f" {comparison} ".join(form.format(self.expression(1)) for _ in range(2))

    def condition(self):
        one = self.comparison
        if self.random.random() < 0.7:
            return f"[{one()}]"
        return f"[[{one()}] {self.random.choice(('AND', 'OR', 'XOR'))} [{one()}]]"

    # -- blocks

    def fragment(self, calls=()):
        kinds = [(6, self.move), (4, self.assign), (2, self.skip), (1, self.then), (1, self.offset), (1, self.local),
                 (1, self.position)]
        if self.depth < 2:
            kinds += [(2, self.count), (1, self.repeat), (1, self.leave_loop)]
        if calls:
            kinds.append((2, lambda: self.call(calls)))
        self.random.choices([k for _, k in kinds], [w for w, _ in kinds])[0]()

    def body(self):
        for _ in range(self.random.randint(1, 3)):
            self.random.choice((self.move, self.assign, self.skip))()

    def move(self):
        axes = self.random.sample("XYZ", self.random.randint(1, 3))
        text = "X" * (LONGEST + 1)
        while len(text) > LONGEST:
            text = self.random.choice(("G0 ", "G1 ")) + " ".join(a + self.random.choice(("", "-")) + self.length()
                                                                 for a in sorted(axes))
        self.block(text)

    def assign(self):
        form = self.random.choice(("180*SIN[{}]", "90*COS[{}]", "ROUND[20*ABS[SIN[{}]]+0.0004]",
                                   "0.5*FUP[30*ABS[COS[{}]]+0.0004]"))
        self.block(f"{self.variable()}=[{form.format(self.expression())}]")  # of a size that does not grow in loops

    def skip(self):
        """A jump over a few blocks: an if around them there."""
        label = self.new_label()
        condition = self.condition()
        self.block(f"IF {condition} GOTO {label}", f"o{label} if [{condition} EQ 0]")
        for _ in range(self.random.randint(1, 2)):
            self.random.choice((self.move, self.assign))()
        self.block(f"N{label}", f"o{label} endif")

    def then(self):
        label = self.new_label()
        condition, assignment = self.condition(), f"#{self.random.choice(VARIABLES)}={self.literal()}"
        self.block(f"IF {condition} THEN {assignment}",
                   f"o{label} if {condition}\n{assignment}\no{label} endif")

    def count(self):
        """WHILE, with a counter that nothing else writes."""
        label, counter = self.new_label(), 20 + self.depth
        self.block(f"#{counter}=0")
        self.depth += 1
        self.block(f"WHILE [#{counter} LT {self.random.randint(0, 4)}] DO{self.depth}",)
        self.theirs[-1] = f"o{label} " + self.ours[-1].replace("WHILE", "while").rsplit(" DO", 1)[0]
        self.block(f"#{counter}=#{counter}+1", f"#{counter}=[#{counter}+1]")
        self.body()
        if self.random.random() < 0.3:
            self.fragment()
        self.block(f"END{self.depth}", f"o{label} endwhile")
        self.depth -= 1

    def repeat(self):
        """A jump back."""
        label, counter = self.new_label(), 23 + self.depth
        self.block(f"#{counter}=0")
        self.block(f"N{label} #{counter}=#{counter}+1", f"o{label} do\n#{counter}=[#{counter}+1]")
        self.body()
        condition = f"[#{counter} LT {self.random.randint(1, 3)}]"
        self.block(f"IF {condition} GOTO {label}", f"o{label} while {condition}")

    def leave_loop(self):
        """A jump out of a loop; LinuxCNC has no do after a break that would run more than once, hence the while."""
        label, out, counter = self.new_label(), self.new_label(), 26 + self.depth
        condition = self.condition()
        self.block(f"#{counter}=3")
        self.depth += 1
        self.block(f"WHILE [#{counter} GT 0] DO{self.depth}", f"#29=1\no{label} while [[#{counter} GT 0] AND [#29 EQ 1]]")
        self.block(f"#{counter}=#{counter}-1", f"#{counter}=[#{counter}-1]")
        self.move()
        self.block(f"IF {condition} GOTO {out}", f"o{out} if {condition}\n#29=0\no{out} else")
        self.move()
        self.block(f"END{self.depth}", f"o{out} endif\no{label} endwhile")
        self.depth -= 1
        self.block(f"N{out}", "")

    def offset(self):
        system = self.random.randint(1, 6)
        self.block(f"G10 L2 P{system} " + " ".join(f"{a}{self.tenths()}" for a in "XYZ"))
        self.block(f"G{53 + system}")

    def local(self):
        self.block(f"G52 X{self.tenths()} Y{self.tenths()}")

    def position(self):
        axis = self.random.randrange(3)
        self.block(f"#{self.random.choice(VARIABLES)}=#{5001 + axis}")
        self.theirs[-1] = self.theirs[-1].replace(f"#{5001 + axis}", f"#{5420 + axis}")

    # -- subprograms

    def call(self, calls):
        kind, number = self.random.choice(calls)
        if kind == "M98":
            self.block(f"M98 P{number}" + self.random.choice(("", "", " L2", " L3")))
            return
        arguments = [self.length() for _ in range(3)]
        self.block(f"G65 P{number} " + " ".join(a + value for a, value in zip("ABC", arguments)),
                   f"o{number} call " + " ".join(arguments))

    def sub(self, kind, number, calls):
        self.block(f"O{number}", f"O{number}" if kind == "M98" else f"o{number} sub")
        if kind == "G65":
            for v in VARIABLES[3:]:
                self.block(f"#{v}={self.literal()}")
        self.depth = 2
        for _ in range(self.random.randint(2, 5)):
            self.fragment(calls)
        self.depth = 0
        self.block("M99", None if kind == "M98" else f"o{number} endsub")

    def new_label(self):
        self.labels += 1
        return 100 + self.labels


def program(seed):
    return MacroProgram(seed).texts
