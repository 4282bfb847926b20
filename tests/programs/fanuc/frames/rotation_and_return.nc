%
O6850 (G28 IS THE FIRST BLOCK AFTER G68 THAT NAMES AN AXIS)
N1 G90 G17 G21 G54 G00 X40. Y30. Z50.
N2 G68 X0. Y0. R90.
(only X returns: its intermediate point is turned, and Y has none)
N3 G28 X10.
N4 X20. Y0.
N5 G69
N6 M30
%
