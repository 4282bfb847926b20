%
O6821 (TILTED PLANES: THE SAME FACE BY EVERY DEFINITION)
(the right face of a block: X' along Y, Y' along Z, Z' along X; origin X100 Y20 Z10)
(every X5. Y6. Z2. is X102 Y25 Z16 in the work offset)
N1 G90 G17 G21 G54 G69 G00 X0. Y0. Z50.
N2 G68.2 X100. Y20. Z10. I90. J90. K0.
N3 X5. Y6. Z2.
N4 G69 X0. Y0. Z50.
N5 G68.2 P1 X100. Y20. Z10. I90. J0. K90.
N6 X5. Y6. Z2.
N7 G69 X0. Y0. Z50.
N8 G68.2 P2 Q1 X100. Y20. Z10.
N9 G68.2 P2 Q2 X100. Y70. Z10.
N10 G68.2 P2 Q3 X100. Y20. Z30.
N11 X5. Y6. Z2.
N12 G69 X0. Y0. Z50.
(a first point elsewhere, and its way to the origin: 20 along X', -5 along Y')
N13 G68.2 P2 Q0 X20. Y-5. Z0. R0.
N14 G68.2 P2 Q1 X100. Y0. Z15.
N15 G68.2 P2 Q2 X100. Y50. Z15.
(a block that does not move may stand between)
N16 M08
N17 G68.2 P2 Q3 X100. Y20. Z30.
N18 X5. Y6. Z2.
N19 G69 X0. Y0. Z50.
N20 G68.2 P3 Q1 X100. Y20. Z10. I0. J1. K0.
N21 G68.2 P3 Q2 I25. J0. K0.
N22 X5. Y6. Z2.
N23 G69 X0. Y0. Z50.
N24 G68.2 P4 X100. Y20. Z10. I90. J0. K90.
N25 X5. Y6. Z2.
N26 G69 X0. Y0. Z50.
(inside a plane that looks up: G68.4 counts in its directions)
N27 G68.2 X100. Y20. Z0. K90.
N28 G68.4 X0. Y0. Z10. J90.
(X' along Y, Y' along Z, Z' along X)
N29 X5. Y6. Z2.
N30 G69 X0. Y0. Z50.
(the reference's plane: X15 Y24.1962 Z54.7321, then X5.8038 Y25 Z54.7321)
N31 G68.2 X10. Y20. Z50. I0. J30. K0.
N32 X5. Y6. Z2.
N33 G69
N34 G68.2 X10. Y20. Z50. I90. J30. K0.
N35 X5. Y6. Z2.
(G69 alone moves nothing; the next block goes to plain coordinates)
N36 G69
N37 X0. Y0. Z50.
N38 M30
%
