; The base frame under G53, a frame of G500, and edges.
; The second edge of tool 5 has a row of its own, 5.2; that of tool 6 is row 106.
G17 G90 G500 T5 M6
D2
G0 X=$TC_DP3[5,2] Y=$TC_DP6[5,2] Z0
$TC_DP3[5,2]=200 $TC_DP12[5,2]=-0.5
D2
X=$TC_DP3[5,2] Z0
T6 M6
$TC_DP3[6,2]=70
D2
X=$TC_DP3[6,2] Z0
; tool 7 has the name 5
T="5" M6
Z0
; G53 leaves the base frame in force, G153 suppresses it
D0
G53 X5 Y6 Z7
G153 X5 Y6 Z7
SUPA X5 Y6 Z7
G53 Z=IC(1)
$P_UIFR[0,X,TR]=100
G500
X0 Y0 Z0
M30
