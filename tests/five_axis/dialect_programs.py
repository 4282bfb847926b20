"""Short five-axis programs in Klartext and for SINUMERIK: where must the tool be?

The expectation of each block is written beside it: the point of the workpiece, the angles of the rotary axes, or the
axes of a plane. The machine is walked forwards (tip_test.Machine) from the machine coordinates to the tip. The
interpreter goes the other way.
"""
import json
import math
import subprocess

TRUNNION = [("A", "table", (1.0, 0.0, 0.0), (0.0, 0.01, -90.0)), ("C", "table", (0.0, 0.0, 1.0), (0.012, -0.03, -150.0))]
NUTATING = [("B", "head", (0.0, math.sqrt(0.5), math.sqrt(0.5)), (0.0, 0.0, 160.0)),
            ("C", "table", (0.0, 0.0, 1.0), (0.0, 0.0, -150.0))]
LIMITS = {"A": 'Minimum="-120" Maximum="120" Rollover="0"', "B": 'Rollover="1"', "C": 'Rollover="1"'}

# Each program: dialect, axes, tools and offsets as XML, text, then what a line wants:
# line: (program point, angles, length of the tool, axes of its plane), or None where nothing may move. A point that is None:
# X Y Z of the machine rest.
def about(n, degrees):
    """The axes of a plane that is turned about X, Y or Z."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return {"X": ((1, 0, 0), (0, c, s), (0, -s, c)), "Y": ((c, 0, -s), (0, 1, 0), (s, 0, c)),
            "Z": ((c, s, 0), (-s, c, 0), (0, 0, 1))}[n]


def turned_rows(inner, outer):
    """The axes `inner` inside those of `outer`."""
    return tuple(tuple(sum(c * outer[k][i] for k, c in enumerate(row)) for i in range(3)) for row in inner)


ONE_TOOL = '<ToolOffsetTable><Tool id="1" H="100"/></ToolOffsetTable>'
PROGRAMS = {
    "IC under M128 turns the frame": (
        "heidenhain", TRUNNION, ONE_TOOL,
        """0 BEGIN PGM T MM
1 TOOL CALL 1 Z S1000
2 M128
3 L X0 Y0 Z0 C+45 F200
4 L X+10 IC+10
5 L IX-3 IA-20 IC-70
6 L X+7 C-15
7 END PGM T MM
""", {4: ((0, 0, 0), {"C": 45}, 100), 5: ((10, 0, 0), {"C": 55}, 100), 6: ((7, 0, 0), {"A": -20, "C": -15}, 100),
      7: None}),
    "DR of a tool call counts under M128": (
        "heidenhain", TRUNNION, '<ToolOffsetTable><Tool id="1" H="100" D="5"/></ToolOffsetTable>',
        """0 BEGIN PGM T MM
1 TOOL CALL 1 Z S1000 DR+0.5
2 M128
3 L X-20 Y0 Z0 C+30 R0 F200
4 L X0 RL
5 L X20
6 L Y20
7 L X40 R0
8 END PGM T MM
""", {4: ((-20, 0, 0), {"C": 30}, 100), 5: ((0, 5.5, 0), {"C": 30}, 100), 6: ((14.5, 5.5, 0), {"C": 30}, 100),
      7: ((14.5, 20, 0), {"C": 30}, 100), 8: ((40, 20, 0), {"C": 30}, 100)}),
    "TABLE ROT turns a free table, COORD ROT puts it at 0": (
        "heidenhain", TRUNNION, ONE_TOOL, """0 BEGIN PGM T MM
1 TOOL CALL 1 Z S1000
2 PLANE SPATIAL SPA0 SPB0 SPC30 STAY SEQ+ TABLE ROT
3 L A+Q120 C+Q122 R0 FMAX
4 L X50 Y5 Z10 FMAX
5 PLANE RESET STAY
6 L A+0 C+90 R0 FMAX
7 PLANE SPATIAL SPA0 SPB0 SPC-20 TURN FMAX TABLE ROT
8 L X50 Y6 Z10 FMAX
9 PLANE SPATIAL SPA0 SPB0 SPC40 TURN FMAX COORD ROT
10 L X50 Y7 Z10 FMAX
11 L C+90 FMAX
12 PLANE SPATIAL SPA0 SPB0 SPC40 MOVE DIST0 FMAX
13 L X50 Y8 Z10 FMAX
14 PLANE SPATIAL SPA0 SPB30 SPC0 TURN FMAX SEQ- TABLE ROT
15 L X50 Y9 Z10 FMAX
16 END PGM T MM
""", {5: ((50, 5, 10), {"C": 30}, 100, about("Z", 30)), 9: ((50, 6, 10), {"C": -20}, 100, about("Z", -20)),
      11: ((50, 7, 10), {"C": 0}, 100, about("Z", 40)), 14: ((50, 8, 10), {"C": 0}, 100, about("Z", 40)),
      16: ((50, 9, 10), {"A": -30, "C": -90}, 100, about("Y", 30))}),
    "A3 B3 C3 turn with ROT": (
        "siemens", TRUNNION, ONE_TOOL, """G17 G90 G710 G54
T1 D1
M6
TRAORI
ROT Z90
G1 X3 Y1 Z2 A3=0 B3=-1 C3=1 F500
AROT X30
G1 X3 Y1 Z2 A3=0 B3=0 C3=1
G2 X5 Y1 I1 J0
G1 X3 Y1 A3=0 B3=0 C3=1
M30
""", {6: ((3, 1, 2), {"A": 45, "C": 90}, 100, about("Z", 90)),
      8: ((3, 1, 2), {"A": 30, "C": 90}, 100, turned_rows(about("X", 30), about("Z", 90))),
      9: ((5, 1, 2), {"A": 30, "C": 90}, 100, turned_rows(about("X", 30), about("Z", 90))),
      10: ((3, 1, 2), {"A": 30, "C": 90}, 100, turned_rows(about("X", 30), about("Z", 90)))}),
    "IC and AC under G91 turn the frame of TRAORI": (
        "siemens", TRUNNION, ONE_TOOL, """G17 G90 G710 G54
T1 D1
M6
TRAORI
G1 X0 Y0 Z0 C45 F500
G91 X10 C=IC(10)
G90 X12 C=AC(50)
G91 X1 C=AC(65) A=IC(-5)
G90 X11 C=IC(-5) A-5
G91 Y1 C5
M30
""", {5: ((0, 0, 0), {"C": 45}, 100), 6: ((10, 0, 0), {"C": 55}, 100), 7: ((12, 0, 0), {"C": 50}, 100),
      8: ((13, 0, 0), {"A": -5, "C": 65}, 100), 9: ((11, 0, 0), {"A": -5, "C": 60}, 100),
      10: ((11, 1, 0), {"A": -5, "C": 65}, 100)}),
    "_DIR takes the alternative where the other is out of reach": (
        "siemens", [("A", "table", (1.0, 0.0, 0.0), (0.0, 0.01, -90.0), 'Minimum="-120" Maximum="30" Rollover="0"'),
                    TRUNNION[1]], ONE_TOOL, """G17 G90 G710 G54
T1 D1
M6
CYCLE800(0,"",0,57,0,0,0,45,0,0,0,0,0,1)
G0 X1 Y2 Z10
M30
""", {5: ((1, 2, 10), {"A": -45, "C": 180}, 100, about("X", 45))}),
    "IC in a plane moves the program point": (
        "heidenhain", TRUNNION, ONE_TOOL, """0 BEGIN PGM T MM
1 TOOL CALL 1 Z S1000
2 PLANE SPATIAL SPA-30 SPB0 SPC0 TURN FMAX
3 L X0 Y0 Z0 FMAX
4 L IC+10 FMAX
5 L X10 Y0 Z0 FMAX
6 L C+10 FMAX
7 END PGM T MM
""", {4: ((0, 0, 0), {"A": -30}, 100, about("X", -30)), 5: (None, {"A": -30, "C": 10}, 100, about("X", -30)),
      6: ((10, 0, 0), {"A": -30, "C": 10}, 100, about("X", -30)), 7: None}),
    "DL of a tool call counts under M128 and TCPM": (
        "heidenhain", TRUNNION, ONE_TOOL,
        """0 BEGIN PGM T MM
1 TOOL CALL 1 Z S1000 DL+0.5
2 M128
3 L X0 Y5 Z0 A-30 F200
4 M129
5 FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS
6 L X3 Y5 Z0 A-20 F200
7 TOOL CALL DL-1
8 L X4 Y5 Z0 A-10 F200
9 END PGM T MM
""", {4: ((0, 5, 0), {"A": -30}, 100.5), 7: ((3, 5, 0), {"A": -20}, 100.5), 9: ((4, 5, 0), {"A": -10}, 99)}),
    "a settable frame shifts the rotary axes, and the tip stays on its path": (
        "siemens", TRUNNION, ONE_TOOL + '<SiemensCoordinateTable><Offset id="BASE" C="4"/>'
        '<Offset id="G54" A="-3" C="6"/><Offset id="G55" C="20"/></SiemensCoordinateTable>',
        """G17 G90 G710 G54
T1 D1
M6
TRAORI
G1 X0 Y0 Z0 A0 C45 F500
G1 X1 C=IC(10)
G1 X2 C=DC(350) A=AC(-10)
G91 G1 X1 C5
G90 SUPA C=DC(30)
G1 X5 Y0 Z0 C30
G1 X6 A3=0 B3=-1 C3=1
G55 G1 X7 A5 C50
G1 X8 C=ACN(340)
G500 G1 X9 C40
M30
""", {5: ((0, 0, 0), {"A": -3, "C": 55}, 100), 6: ((1, 0, 0), {"A": -3, "C": 65}, 100),
      7: ((2, 0, 0), {"A": -13, "C": 0}, 100), 8: ((3, 0, 0), {"A": -13, "C": 5}, 100),
      9: ((3, 0, 0), {"A": -13, "C": 30}, 100), 10: ((5, 0, 0), {"A": -13, "C": 40}, 100),
      11: ((6, 0, 0), {"A": 45}, 100), 12: ((7, 0, 0), {"A": 5, "C": 74}, 100),
      13: ((8, 0, 0), {"A": 5, "C": 4}, 100), 14: ((9, 0, 0), {"A": 5, "C": 44}, 100)}),
    "IC in a plane of CYCLE800 moves the program point": (
        "siemens", TRUNNION, ONE_TOOL + '<SiemensCoordinateTable><Offset id="G54" C="6"/></SiemensCoordinateTable>',
        """G17 G90 G710 G54
T1 D1
M6
CYCLE800(0,"",0,57,0,0,0,-30,0,0,0,0,0,-1)
G1 X0 Y0 Z0 F500
G1 C=IC(10)
G1 X10 Y0 Z0
G91 G1 C=AC(5)
G90 G1 X10 Y0 Z0
M30
""", {5: ((0, 0, 0), {"A": -30, "C": 0}, 100, about("X", -30)),
      6: (None, {"A": -30, "C": 10}, 100, about("X", -30)),
      7: ((10, 0, 0), {"A": -30, "C": 10}, 100, about("X", -30)),
      8: (None, {"A": -30, "C": 11}, 100, about("X", -30)),
      9: ((10, 0, 0), {"A": -30, "C": 11}, 100, about("X", -30))}),
    "a preset shifts the rotary axes, and the tip stays on its path": (
        "heidenhain", TRUNNION, ONE_TOOL + '<IsoCoordinateTable><Offset id="DATUM_PRESET_1" A="-3" C="6"/>'
        '</IsoCoordinateTable>', """0 BEGIN PGM T MM
1 CYCL DEF 247 Q339=+1
2 TOOL CALL 1 Z S1000
3 M128
4 L X0 Y0 Z0 A+0 C+45 F200
5 L X+1 IC+10
6 L C+30 R0 F200 M91
7 L X+2 Y+0 Z+0 C+20
8 M129
9 PLANE SPATIAL SPA-30 SPB0 SPC0 STAY SEQ-
10 L A+Q120 C+Q122 FMAX
11 L X3 Y0 Z0 FMAX
12 PLANE SPATIAL SPA-30 SPB0 SPC0 TURN FMAX SEQ-
13 L X4 Y0 Z0 FMAX
14 PLANE AXIAL A-27 C-6 TURN FMAX
15 L X5 Y0 Z0 FMAX
16 END PGM T MM
""", {5: ((0, 0, 0), {"A": -3, "C": 51}, 100), 6: ((1, 0, 0), {"A": -3, "C": 61}, 100),
      7: (None, {"A": -3, "C": 30}, 100), 8: ((2, 0, 0), {"A": -3, "C": 26}, 100),
      12: ((3, 0, 0), {"A": -30, "C": 0}, 100, about("X", -30)),
      14: ((4, 0, 0), {"A": -30, "C": 0}, 100, about("X", -30)),
      16: ((5, 0, 0), {"A": -30, "C": 0}, 100, about("X", -30))}),
}


def machine_xml(axes):
    rows = "".join(f'<Axis name="{a}" {limits[0] if limits else LIMITS[a]}/>' for a, _, _, _, *limits in axes)
    kinematics = "".join(
        f'<Axis name="{a}" Place="{place}" Order="{i + 1}" X="{n[0]!r}" Y="{n[1]!r}" Z="{n[2]!r}" '
        f'PivotX="{p[0]!r}" PivotY="{p[1]!r}" PivotZ="{p[2]!r}"/>' for i, (a, place, n, p, *_) in enumerate(axes))
    linear = "".join(f'<Axis name="{a}"/>' for a in "XYZ")
    return f"<MachineAxes>{linear}{rows}</MachineAxes><MachineKinematics>{kinematics}</MachineKinematics>"


def motions(isogloss, plugins, folder, stem):
    """The events of STEM.nc under the dialect STEM.xml, and the diagnostics."""
    command = [isogloss, "run", f"{stem}.nc", "-d", f"{stem}.xml", "--emit", "motions", "--format", "jsonl", "--exact"]
    if plugins:
        command += ["--plugins", plugins]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode > 1:
        raise RuntimeError(done.stderr)
    return [json.loads(line) for line in done.stdout.splitlines()], done.stderr


def run(isogloss, plugins, folder, name):
    dialect, axes, tables, text, _ = PROGRAMS[name]
    (folder / "short.xml").write_text(f"""<?xml version="1.0" encoding="UTF-8"?>
<Dialect xmlns="urn:isogloss:dialect:1" name="short" title="short programs" extends="{dialect}">
  <Plugins><Plugin name="kinematics"/></Plugins>
  <Dependencies>{tables}{machine_xml(axes)}</Dependencies>
</Dialect>
""")
    (folder / "short.nc").write_text(text)
    return motions(isogloss, plugins, folder, "short")


def check(isogloss, plugins, folder, machine_of):
    """One text for each thing that is wrong."""
    failures = []
    rest = [0, 0, 0]
    for name, (_, axes, _, text, wanted) in PROGRAMS.items():
        events, said = run(isogloss, plugins, folder, name)
        machine = machine_of([axis[:4] for axis in axes])
        last = {e["Line"]: e for e in events if e.get("Event") in ("rapid", "feed", "arc")}
        for line, goal in wanted.items():
            event = last.get(line)
            block = f"{name}, line {line}: {text.splitlines()[line - 1]}\n  "
            if goal is None or event is None:
                if (goal is None) != (event is None):
                    failures.append(f"{block}{'moves' if event else 'no move'}: {event}\n{said}")
                continue
            point, angles, length, *plane = goal
            x, y, z = plane[0] if plane else ((1, 0, 0), (0, 1, 0), (0, 0, 1))
            at = event["MachineCoordinate"]
            has = {a: at.get(a, 0.0) for a in machine.letters}
            tip = machine.in_workpiece(machine.tip([at[a] for a in "XYZ"], has, length), has)
            in_plane = [sum(a * b for a, b in zip(tip, axis)) for axis in (x, y, z)]
            shown = [event["ProgramXyz"][a] for a in "XYZ"]
            astray = math.dist(in_plane, shown)
            off = math.dist(in_plane, point) if point else math.dist(rest, [at[a] for a in "XYZ"])
            if not point and "Form" in event:
                failures.append(f"{block}X Y Z rest, but the tip is said to be led: {event}\n{said}")
            turned = max(abs(math.remainder(has[a] - angles.get(a, 0), 360)) for a in has)
            if off > 1e-6 or turned > 1e-6 or astray > 1e-6:
                failures.append(f"{block}tip off by {off:.3g} mm, an axis by {turned:.3g} degrees, the program point by "
                                f"{astray:.3g} mm: {event}\n{said}")
            rest = [at[a] for a in "XYZ"]
    return failures
