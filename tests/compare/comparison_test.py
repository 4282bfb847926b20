#!/usr/bin/env python3
"""Does the comparison find the differences that it is meant to find? Needs neither rs274 nor isogloss."""
import copy
import unittest

import canon
import linuxcnc
import moves

CANON = """
    1 N1     USE_LENGTH_UNITS(CANON_UNITS_MM)
    2 N2     SET_G5X_OFFSET(1, 100.0000, 50.0000, -30.0000, 0.0000, 0.0000, 0.0000)
    3 N3     USE_TOOL_LENGTH_OFFSET(0.0000 0.0000 88.9000, 0.0000 0.0000 0.0000, 0.0000 0.0000 0.0000)
    4 N4     STRAIGHT_TRAVERSE(10.0000, 0.0000, 50.0000, 0.0000, 0.0000, 0.0000)
    5 N5     SET_FEED_RATE(600.0000)
    6 N5     ARC_FEED(20.0000, 10.0000, 20.0000, 0.0000, -1, 50.0000, 0.0000, 0.0000, 0.0000)
    7 N6     SELECT_PLANE(CANON_PLANE_XZ)
    8 N7     ARC_FEED(50.0000, 20.0000, 55.0000, 20.0000, 1, 12.0000, 0.0000, 0.0000, 0.0000)
    9 N8     USE_LENGTH_UNITS(CANON_UNITS_INCHES)
   10 N9     STRAIGHT_FEED(1.0000, 1.0000, 1.0000, 0.0000, 0.0000, 0.0000)
   11 N10    STRAIGHT_FEED(1.0000, 1.0000, 1.0000, 0.0000, 0.0000, 0.0000)
   12 N11    DWELL(0.5000)
   13 N12    PROGRAM_END()
"""


def read(text):
    reader = canon.Canon()
    result = list(moves.without_zero_moves(list(reader.read(text))))
    assert reader.ended
    return result


class Comparison(unittest.TestCase):
    def setUp(self):
        self.moves = read(CANON)

    def test_offsets_and_tool_length_give_machine_coordinates(self):
        rapid = self.moves[0]
        self.assertEqual((rapid.kind, rapid.line), ("rapid", 4))
        for value, expected in zip(rapid.end, (110, 50, 108.9)):
            self.assertAlmostEqual(value, expected)

    def test_arc(self):
        arc = self.moves[1]
        self.assertEqual((arc.plane, arc.ccw, arc.feed), ("XY", False, 10.0))
        self.assertAlmostEqual(arc.centre[0], 120)
        self.assertAlmostEqual(arc.sweep, 90)

    def test_full_circle_in_zx_with_its_third_axis(self):
        arc = self.moves[2]
        self.assertEqual((arc.plane, arc.ccw), ("ZX", True))
        self.assertAlmostEqual(arc.sweep, 360)
        self.assertAlmostEqual(arc.end[1], 62)

    def test_inches_and_zero_moves(self):
        self.assertEqual([m.kind for m in self.moves], ["rapid", "arc", "arc", "feed", "dwell"])
        self.assertAlmostEqual(self.moves[3].end[0], 125.4)

    def test_equal_moves_do_not_differ(self):
        for a, b in zip(self.moves, copy.deepcopy(self.moves)):
            self.assertIsNone(moves.difference(a, b))

    def test_every_planted_error_is_seen(self):
        plants = [(0, "kind", "feed"), (0, "line", 5), (0, "end", (110.0002, 50.0, 108.9)),
                  (0, "angles", (0.0, 0.001, 0.0)),
                  (1, "end", (120.0, 60.0, 108.8998)), (1, "ccw", True), (1, "plane", "YZ"),
                  (1, "centre", (120.0, 50.0003)), (1, "sweep", 450.0), (1, "sweep", 90.01), (1, "feed", 10.001),
                  (4, "value", 0.501)]
        for index, name, value in plants:
            with self.subTest(f"{name} = {value}"):
                ours = copy.deepcopy(self.moves[index])
                setattr(ours, name, value)
                self.assertIsNotNone(moves.difference(ours, self.moves[index]))

    def test_program_for_linuxcnc(self):
        self.assertEqual(linuxcnc.translated("%\nN7 G4 P500\nG99 G82 X1. P250 K3\nG10 L2 P1 X1.\nG10L10P2R3.\n"),
                         "%\nN2 G4 P0.5\nN3 G99 G82 X1. P0.25 L3\nN4 G10 L2 P1 X1.\nN5 G10L1P2Z3.\n")

    def test_motion_stream(self):
        text = ("file,line,event,px,py,pz,mx,my,mz,a,b,c,feed_mm_s,cx,cy,cz,ccw,circles,plane,mcx,mcy,mcz,nx,ny,nz,"
                "sweep,value,term\n"
                "p.nc,5,arc,20,10,50,120,60,108.9,,,,10,20,0,50,0,0,XY,120,50,108.9,0,0,1,-90,,\n"
                "p.nc,6,spindle,,,,,,,,,,,,,,,,,,,,,,,,1000,CW\n"
                "p.nc,11,dwell,,,,,,,,,,,,,,,,,,,,,,,,0.5,\n")
        arc, dwell = moves.from_csv(text)
        self.assertIsNone(moves.difference(arc, self.moves[1]))
        self.assertIsNone(moves.difference(dwell, self.moves[4]))


if __name__ == "__main__":
    unittest.main()
