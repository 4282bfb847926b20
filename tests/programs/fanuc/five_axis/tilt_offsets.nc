%
O6823 (TILTED PLANE, OFFSETS, LENGTH, INCHES)
(G54 X10 Y20 Z30, G55 X-10 Y-20 Z-30, H1 100)
N1 G90 G17 G21 G54 G69 G49 G00 X0. Y0. Z50.
N2 G43 H1 Z50.
(offset and length come after the plane and are not turned by it: X112 Y45 Z146)
N3 G68.2 X100. Y20. Z10. I90. J90. K0.
N4 X5. Y6. Z2.
N5 G49
(without the length: Z46)
N6 X5. Y6. Z2.
N7 G69
N8 G00 X0. Y0. Z50.
(G52 is not turned either: X113 Y45 Z46)
N9 G52 X1. Y0. Z0.
N10 G68.2 X100. Y20. Z10. I90. J90. K0.
N11 X5. Y6. Z2.
(the increment before the first absolute block starts where the tool stands)
N12 G69
N13 G52 X0. Y0. Z0.
N14 G00 X0. Y0. Z0.
N15 G68.2 X100. Y20. Z10. I90. J90. K0.
N16 G91 X5.
N17 Z3.
N18 G90 G69
N19 X0. Y0. Z0.
(inches: the origin is scaled, angles and vectors are not)
N20 G20
N21 G68.2 X1. Y2. Z0. I90. J90. K0.
N22 X0.1 Y0.2 Z0.
N23 G69
N24 G68.2 P3 Q1 X1. Y2. Z0. I0. J1. K0.
N25 G68.2 P3 Q2 I1. J0. K0.
N26 X0.2 Y0.2 Z0.
N27 G21 G69
N28 X0. Y0. Z50.
(what controls forbid inside a plane: said, the plane stays)
N29 G68.2 X100. Y0. Z0. I90. J90. K0.
N30 X0. Y0. Z0.
N31 G55
N32 X0. Y0. Z0.
N33 G53 Z0.
N34 G91 G28 Z0.
N35 G90 G69 G54
N36 G00 X0. Y0. Z50.
N37 M30
%
