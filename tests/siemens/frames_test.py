#!/usr/bin/env python3
"""Random chains of TRANS, ATRANS, ROT, AROT, SCALE, ASCALE, MIRROR, AMIRROR, CYCLE800, G54 to G505, G53 and D against
plain matrices. Settable frames and the base frame shift, rotate, scale and mirror, too.

  frames_test.py --isogloss PATH [--programs N] [--seed S]

The model follows the manual's description of frames: machine = tool + base frame (settable frame (swivelled plane
(programmable frame (words)))), each of them shift, rotation (scale (mirror)). Every move, arcs and helices included, must end where the model does, to 1e-6 mm, and each arc must
have the centre and the sense that result from the frame.
"""
import csv
import math
import pathlib
import random
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

import random_runs  # noqa: E402: it lies in another folder

NORMAL = {"G17": 2, "G18": 1, "G19": 0}
# Columns of the table; G54 and G57 only shift. Programs with an odd seed have a base frame, and those with a seed that
# 3 divides have a frame for G500.
OFFSETS = {"G54": {"X": 10.0, "Y": -20.0, "Z": 30.5}, "G57": {"X": -7.25, "Y": 3.0, "Z": -100.0, "FX": 0.02, "FZ": -0.3},
           "G505": {"X": 1.0, "Y": 2.0, "Z": 3.0, "RZ": 33.0}, "G506": {"X": -5.5, "RX": 20.0, "RY": -35.5, "RZ": 110.0},
           "G507": {"Y": 4.0, "FY": 0.5, "RX": -15.0, "SX": 1.5, "SY": 1.5, "SZ": 1.5, "MX": 1},
           "G508": {"RZ": -12.5, "MY": 1, "MZ": 1, "SZ": 0.75}, "G509": {}, "G500": {}}
ROTATED_G500 = {"X": 2.5, "FY": -0.75, "RZ": 15.0, "MX": 1}
BASE = {"X": 3.0, "Z": -1.5, "FX": 0.125, "RX": 5.0, "RZ": -20.0}
LENGTH = 57.3
IDENTITY = ([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.0, 0.0, 0.0])
ORDERS = {57: "XYZ", 27: "ZYX", 39: "ZXY", 45: "XZY", 30: "YZX", 54: "YXZ"}


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def turned(m, v):
    return [sum(m[i][k] * v[k] for k in range(3)) for i in range(3)]


def plus(*vectors):
    return [sum(c) for c in zip(*vectors)]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def after(outer, inner):
    """The frame that first does `inner`, then `outer`."""
    return times(outer[0], inner[0]), plus(turned(outer[0], inner[1]), outer[1])


def apply(frame, p):
    return plus(turned(frame[0], p), frame[1])


def about(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    u, v = (axis + 1) % 3, (axis + 2) % 3
    m = [list(row) for row in IDENTITY[0]]
    m[u][u], m[u][v], m[v][u], m[v][v] = c, -s, s, c
    return m


def determinant(m):
    return sum(m[0][i] * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] - m[1][(i + 2) % 3] * m[2][(i + 1) % 3]) for i in range(3))


def inverse(frame):
    m, t = frame
    d = determinant(m)
    cofactor = lambda i, j: (m[(i + 1) % 3][(j + 1) % 3] * m[(i + 2) % 3][(j + 2) % 3]
                             - m[(i + 1) % 3][(j + 2) % 3] * m[(i + 2) % 3][(j + 1) % 3])
    back = [[cofactor(j, i) / d for j in range(3)] for i in range(3)]
    return back, [-x for x in turned(back, t)]


def frame_of(row):
    """The frame of a row of the table."""
    v = lambda kind, unnamed: [float(row.get(kind + a, unnamed)) for a in "XYZ"]
    r = v("R", 0)
    factors = [-s if m else s for s, m in zip(v("S", 1), v("M", 0))]
    m = times(times(about(2, r[2]), about(1, r[1])), about(0, r[0]))
    return [[m[i][k] * factors[k] for k in range(3)] for i in range(3)], plus(v("", 0), v("F", 0))


class Program:
    def __init__(self, seed, blocks=120):
        self.random = random.Random(seed)
        self.table = {name: dict(row) for name, row in OFFSETS.items()}
        self.table["G500"] = self.g500 = dict(ROTATED_G500) if seed % 3 == 0 else {}
        self.base = BASE if seed % 2 else {}
        self.lines, self.ends, self.arcs = [], {}, {}
        self.at = [0.0, 0.0, 0.0]  # machine coordinates
        self.in_force, self.plane, self.length = self.g500, "G17", 0.0
        self.programmable, self.swivel = IDENTITY, IDENTITY
        self.is_incremental, self.is_swivelled = False, False
        self.write("G17 G90 G94 F500 G500 T1 M6 D0")
        self.write("SUPA G0 X0 Y0 Z0")
        self.ends[2] = [0.0, 0.0, 0.0]
        steps = [(30, self.move), (9, self.frame), (3, self.swivelled), (3, self.settable), (1, self.written), (3, self.machine_block),
                 (2, self.distance), (2, self.plane_code), (2, self.edge), (9, self.arc)]
        for step in self.random.choices([s for _, s in steps], [w for w, _ in steps], k=blocks):
            step()
        self.write("M30")

    def write(self, text):
        self.lines.append(text)

    def value(self, low=-80, high=80):
        return round(self.random.uniform(low, high), 3)

    def words(self, least=1):
        return {a: self.value() for a in self.random.sample(range(3), self.random.randint(least, 3))}

    @staticmethod
    def text(words):
        return " ".join("XYZ"[a] + f"{v:.3f}" for a, v in words.items())

    # ---- what is in force

    def tool(self):
        return [self.length if a == NORMAL[self.tool_plane] else 0.0 for a in range(3)] if self.length else [0.0] * 3

    def way(self):
        outside = after((IDENTITY[0], self.tool()), after(frame_of(self.base), frame_of(self.in_force)))
        return after(outside, after(self.swivel, self.programmable))

    def position(self):
        return apply(inverse(self.way()), self.at)

    def go(self, target):
        self.at = apply(self.way(), target)
        self.ends[len(self.lines)] = list(self.at)

    # ---- steps

    def move(self):
        target, words = self.position(), self.words()
        texts = []
        for axis, v in words.items():
            how = self.random.choice(("", "", "", "AC", "IC"))
            is_step = how == "IC" or (not how and self.is_incremental)
            target[axis] = target[axis] + v if is_step else v
            texts.append("XYZ"[axis] + (f"={how}({v:.3f})" if how else f"{v:.3f}"))
        self.write(self.random.choice(("G0 ", "G1 ")) + " ".join(texts))
        self.go(target)

    def keeps_circles(self):
        """In the plane in force."""
        u, v = ([row[a] for row in self.way()[0]] for a in range(3) if a != NORMAL[self.plane])
        return abs(math.hypot(*u) - math.hypot(*v)) < 1e-9 and abs(sum(a * b for a, b in zip(u, v))) < 1e-9

    def arc(self):
        if not self.keeps_circles():
            return
        normal = NORMAL[self.plane]
        u, v = (normal + 1) % 3, (normal + 2) % 3
        start, end = self.position(), self.position()
        radius, begin = self.random.uniform(2, 40), self.random.uniform(0, 2 * math.pi)
        sweep = self.random.uniform(0.2, 6.0) * self.random.choice((-1, 1))
        centre = list(start)
        centre[u] -= radius * math.cos(begin)
        centre[v] -= radius * math.sin(begin)
        end[u] = centre[u] + radius * math.cos(begin + sweep)
        end[v] = centre[v] + radius * math.sin(begin + sweep)
        end[normal] += self.random.choice((0, self.value(-20, 20)))
        code = "G3" if sweep > 0 else "G2"
        axes = " ".join(f"{'XYZ'[a]}=AC({end[a]:.9f})" for a in range(3))
        way = self.random.choice(("centre", "absolute centre", "radius", "angle", "angle and centre", "through"))
        if way == "through":
            end[normal] = start[normal]
            axes = " ".join(f"{'XYZ'[a]}=AC({end[a]:.9f})" for a in range(3))
            middle = list(start)
            middle[u] = centre[u] + radius * math.cos(begin + sweep / 3)
            middle[v] = centre[v] + radius * math.sin(begin + sweep / 3)
            self.write(f"CIP {axes} " + " ".join(f"{'IJK'[a]}1=AC({middle[a]:.9f})" for a in (u, v)))
        elif way == "angle and centre":
            tool = f"{'XYZ'[normal]}=AC({end[normal]:.9f})"
            self.write(f"{code} {tool} AR={math.degrees(abs(sweep)):.9f} "
                       + " ".join(f"{'IJK'[a]}={centre[a] - start[a]:.9f}" for a in (u, v)))
        else:
            words = {"centre": " ".join(f"{'IJK'[a]}={centre[a] - start[a]:.9f}" for a in (u, v)),
                     "absolute centre": " ".join(f"{'IJK'[a]}=AC({centre[a]:.9f})" for a in (u, v)),
                     "radius": f"CR={radius if abs(sweep) <= math.pi else -radius:.9f}",
                     "angle": f"AR={math.degrees(abs(sweep)):.9f}"}[way]
            self.write(f"{code} {axes} {words}")
        way_to_machine = self.way()
        axis = turned(way_to_machine[0], [float(a == normal) for a in range(3)])
        if determinant(way_to_machine[0]) < 0:
            axis = [-x for x in axis]
        self.arcs[len(self.lines)] = (apply(way_to_machine, centre), axis, math.degrees(sweep))
        self.go(end)
        self.write("G1")

    def frame(self):
        kind = self.random.choice(("TRANS", "ROT", "SCALE", "MIRROR", "RPL"))
        prefix = self.random.choice(("", "A"))
        words = {} if self.random.random() < 0.1 else self.words()
        if kind == "TRANS":
            own = (IDENTITY[0], [words.get(a, 0.0) for a in range(3)])
        elif kind == "RPL":
            angle = self.value(-180, 180)
            own, words = (about(NORMAL[self.plane], angle), [0.0] * 3), None
        elif kind == "ROT":
            words = {a: v for a, v in words.items()}
            m = times(times(about(2, words.get(2, 0)), about(1, words.get(1, 0))), about(0, words.get(0, 0)))
            own = (m, [0.0] * 3)
        else:
            scale = kind == "SCALE"
            if scale and words:
                factor = round(self.random.uniform(0.5, 2), 2)
                words = {a: factor for a in range(3)}
                if self.random.random() < 0.5:
                    words.pop(self.random.choice((NORMAL[self.plane], self.random.randrange(3))))
            own = ([[(words.get(i, 1.0) if scale else -1.0 if i in words else 1.0) if i == j else 0.0 for j in range(3)]
                    for i in range(3)], [0.0] * 3)
        self.programmable = after(self.programmable, own) if prefix else own
        name = prefix + ("ROT" if kind == "RPL" else kind)
        self.write(f"{name} RPL={angle:.3f}" if words is None else f"{name} {self.text(words)}".rstrip())
        if max(abs(x) for row in self.programmable[0] for x in row) > 20 or abs(determinant(self.programmable[0])) < 1e-3:
            self.programmable = IDENTITY
            self.write("TRANS")

    def swivelled(self):
        if self.random.random() < 0.3:
            self.swivel, self.is_swivelled = IDENTITY, False
            self.programmable = IDENTITY
            self.write("CYCLE800()")
            return
        mode = self.random.choice(list(ORDERS) + [64])
        a, b, c = (self.value(-90, 90) for _ in range(3))
        m = IDENTITY[0]
        for axis, degrees in zip("ZY" if mode == 64 else ORDERS[mode], (a, b, c)):
            m = times(m, about("XYZ".index(axis), degrees))
        before, behind = [self.value() for _ in range(3)], [self.value() for _ in range(3)]
        own = (m, plus(before, turned(m, behind)))
        is_additive = self.random.random() < 0.3
        if is_additive and self.is_swivelled:
            self.swivel = after(self.swivel, own)
        else:
            self.swivel = own
        if not is_additive:
            self.programmable = IDENTITY
        self.is_swivelled = True
        values = [0, '"T"', int(is_additive), mode, *before, a, b, c, *behind, 0]
        self.write("CYCLE800(" + ",".join(str(v) for v in values) + ")")

    def settable(self):
        code = self.random.choice(list(OFFSETS))
        self.in_force = dict(self.table[code])
        self.write(code)

    def written(self):
        """A frame that the program writes; the next code selects it."""
        row = self.table["G509"]
        kind = self.random.choice(("part", "part", "part", "whole", "copy"))
        if kind == "whole":
            row.clear()
            row.update({"X": self.value(), "Y": self.value()})
            self.write(f"$P_UIFR[9]=CTRANS(X,{row['X']:.3f},Y,{row['Y']:.3f})")
        elif kind == "copy":
            row.clear()
            row.update(self.table["G506"])
            self.write("$P_UIFR[9]=$P_UIFR[6]")
        else:
            axis, part = self.random.choice("XYZ"), self.random.choice(("TR", "FI", "RT", "SC", "MI"))
            v = {"SC": 1.25, "MI": self.random.randint(0, 1)}.get(part, self.value())
            if part == "SC":  # one factor for all axes, so that circles remain
                for a in "XYZ":
                    row["S" + a] = v
                    self.write(f"$P_UIFR[9,{a},SC]={v}")
                return
            row[{"TR": "", "FI": "F", "RT": "R", "MI": "M"}[part] + axis] = v
            self.write(f"$P_UIFR[9,{axis},{part}]={v}")

    def machine_block(self):
        words = self.words()
        code = self.random.choice(("G53", "G153", "SUPA"))
        self.write(f"{code} G0 {self.text(words)}")
        base = frame_of(self.base) if code == "G53" else IDENTITY
        target = apply(inverse(base), minus(self.at, self.tool()))
        for axis, v in words.items():
            target[axis] = target[axis] + v if self.is_incremental else v
        self.at = plus(apply(base, target), self.tool())
        self.ends[len(self.lines)] = list(self.at)

    def distance(self):
        self.is_incremental = not self.is_incremental
        self.write("G91" if self.is_incremental else "G90")

    def plane_code(self):
        if self.length:
            return
        self.plane = self.random.choice(list(NORMAL))
        self.write(self.plane)

    def edge(self):
        if self.length:
            self.length = 0.0
            self.write("D0")
        else:
            self.length, self.tool_plane = LENGTH, self.plane
            self.write("D1")
        self.write("G0 X=AC(1) Y=AC(2) Z=AC(3)")
        self.go([1.0, 2.0, 3.0])


def difference(isogloss, folder, program):
    (folder / "in.mpf").write_text("\n".join(program.lines) + "\n")
    settings = [w for row, cells in (OFFSETS | {"BASE": program.base, "G500": program.g500}).items() for column, v in cells.items()
                for w in ("--set", f"SiemensCoordinateTable.{row}.{column}={v}")]
    settings += ["--set", f"ToolOffsetTable.1.H={LENGTH}"]
    run = subprocess.run([isogloss, "run", "in.mpf", "-d", "siemens", "--checked", "--emit", "motions", "--format",
                          "csv", "--exact", "--zero-moves", *settings], cwd=folder, capture_output=True, text=True, timeout=60, check=False)
    if run.returncode != 0 or "warning" in run.stderr:
        return 0, f"isogloss ends with {run.returncode}: {run.stderr[:600]}"
    rows = {int(row["line"]): row for row in csv.DictReader(run.stdout.splitlines())
            if row["event"] in ("rapid", "feed", "arc")}
    for line, wanted in sorted(program.ends.items()):
        row = rows.get(line)
        if row is None:
            return line, f"line {line}, {program.lines[line - 1]}: no move"
        got = [float(row[c]) for c in ("mx", "my", "mz")]
        if math.dist(wanted, got) > 1e-6:
            return line, f"line {line}, {program.lines[line - 1]}: {got} instead of {wanted}"
        if line not in program.arcs:
            continue
        if row["event"] != "arc":
            return line, f"line {line}, {program.lines[line - 1]}: no arc"
        centre, axis, sweep = program.arcs[line]
        got = [float(row[c]) for c in ("mcx", "mcy", "mcz")]
        normal = [float(row[c]) for c in ("nx", "ny", "nz")]
        turn = float(row["sweep"]) * (1 if sum(a * b for a, b in zip(axis, normal)) > 0 else -1)
        if math.dist(centre, got) > 1e-5 or abs(turn - sweep) > 1e-4:
            return line, f"line {line}, {program.lines[line - 1]}: about {got}, {turn} degrees, not {centre}, {sweep}"
    return len(program.ends), None


if __name__ == "__main__":
    sys.exit(random_runs.run(__doc__, Program, difference, ".mpf"))
