%
O6822 (INSIDE A TILTED PLANE: ARCS, CYCLES, INCREMENTS)
(the right face: X' along Y, Y' along Z, Z' along X; origin X100)
N1 G90 G17 G21 G54 G69 G00 X0. Y0. Z50. M03 S1000
N2 G68.2 X100. Y0. Z0. I90. J90. K0.
N3 G00 X10. Y10. Z20.
(arcs turn about Z', which is X: the sense is seen from +X)
N4 G01 Z-1. F300
N5 G02 X20. Y20. I10. J0.
N6 G03 X30. Y10. R10.
N7 G02 I5.
(a helix climbs along Z')
N8 G03 X40. Y10. Z-3. I5. J0.
(G18 and G19 are planes of the tilted system)
N9 G18 G02 X50. Z-3. I5. K0.
N10 G19 G03 Y20. Z-3. J5. K0.
N11 G17 G00 Z20.
(cycles drill along Z', which is -X going down)
N12 G98 G81 X10. Y10. Z-5. R2. F200
N13 G99 X30.
N14 G83 Y30. Z-12. R2. Q5.
N15 G73 X10. Z-12. R2. Q5.
N16 G98 G82 X20. Y20. Z-4. R2. P500
N17 G84 X20. Y40. Z-10. R5. F1000
N18 G85 X30. Y40. Z-8. R2. F100
N19 G86 X40. Y40. Z-8. R2.
N20 G76 X50. Y40. Z-8. R2. Q0.5
N21 G80
(increments, and repeats of a cycle along X')
N22 G91 G00 X-10. Y-10.
N23 G81 X5. Z-7. R-15. F200 K3
N24 G90 G80
(polar: a radius of 20 at 30 degrees from X')
N25 G16 G00 X20. Y30.
N26 G15
(half the size about the origin of the plane)
N27 G51 X0. Y0. Z0. P500
N28 G01 X40. Y20. F300
N29 G03 X20. Y20. R10.
N30 G50
(mirrored in X' at 10)
N31 G51.1 X10.
N32 G00 X20. Y5.
N33 G02 X30. Y15. I10. J0. F300
N34 G50.1 X0
(a slanted plane: every Z' is 30 degrees off the vertical)
N35 G69
N36 G68.2 X0. Y0. Z0. I0. J30. K0.
N37 G00 X0. Y10. Z10.
N38 G81 X10. Y10. Z-10. R1. F200
N39 G80
N40 G01 X10. Y0. Z0. F300
N41 G03 X0. Y10. R10.
N42 G69 M05
N43 G00 Z100.
N44 M30
%
