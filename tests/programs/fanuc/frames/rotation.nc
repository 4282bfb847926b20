%
O6801 (COORDINATE ROTATION IN XY)
N1 G90 G17 G21 G54 G00 X0. Y0. Z50.
(the manual's figures: 30 degrees about X20 Y10)
N2 G68 X20. Y10. R30.
N3 X50. Y10.
N4 Y40.
(arcs keep sense and radius, their centre turns)
N5 G01 X20. F600
N6 G02 X30. Y50. I10. J0
N7 G03 X40. Y40. R10.
N8 G02 I5.
(cycles drill along Z at the turned places)
N9 G98 G81 X10. Y0. Z-5. R2. F200
N10 G91 X10. K2
N11 G90 G80
(G53 knows no rotation)
N12 G53 G00 Z-1.
N13 G69 X0. Y0. Z50.
(no centre: where the tool stands)
N14 G00 X5. Y5.
N15 G68 R-90.
N16 X10. Y5.
(a second G68 replaces the first)
N17 G68 X0 Y0 R180.
N18 X10. Y5.
N19 G69
N20 X10. Y5.
(one axis alone: 10 and 14.142 are turned by 45 degrees)
N21 X10. Y10.
N22 G68 X0 Y0 R45.
N23 Y14.142
N24 G69 X0 Y0
(increments before the first absolute block turn about the tool)
N25 G68 X20. Y0 R90.
N26 G91 X10.
N27 Y5.
(and the centre counts from here on)
N28 G90 X30.
N29 X30. Y0.
N30 G69 X0. Y0.
(a cycle with one axis as the first absolute block)
N31 G68 X0 Y0 R90.
N32 G99 G81 X10. Z-5. R2.
N33 G80
N34 G69
(R counts thousandths of a degree without a point)
N35 G68 X0 Y0 R90000
N36 G00 X1. Y0.
N37 G69
N38 M30
%
