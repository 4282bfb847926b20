; Outer corners, the ends of the contour and the feed on arcs under G41: radius 2.
G17 G710 G90 G94 G0 X-20 Y-20 Z5
T1 M6
S1000 M3 F600
; G450: an arc about each corner.
G41 G1 X0 Y0
Y30
G2 X20 Y50 CR=20
G451 G1 X40
; G451: to the crossing, with a line and with the circle of an arc; round where the contour bends by more than 100 degrees.
Y40
X45
G2 X50 Y35 CR=5
G1 X45 Y30
X60 Y20
X20 Y15
X0 Y0
G40 X-20 Y-20
G450
; NORM: straight to the first point, KONT: round it where the tool starts behind the contour.
G41 G1 X0 Y0
X30
G40 X50 Y-20
KONT
G41 G1 X0 Y0
X30
G40 X50 Y-20
G0 X-20 Y20
; In front of the contour KONT is NORM.
G41 G1 X0 Y0
X30
G40 X50 Y20
G451 G0 X-20 Y-5
G41 G1 X0 Y0
X30
G40 X50 Y-5
G0 Y-20
G450 NORM
; CFC, CFTCP and CFIN: where F holds, inside and outside of an arc.
G41 G1 X0 Y0
X10
G3 X20 Y10 CR=10
G2 X30 Y20 CR=10
CFTCP
G3 X40 Y30 CR=10
G2 X50 Y40 CR=10
CFIN
G3 X60 Y50 CR=10
G2 X70 Y60 CR=10
CFC
G1 X80
G40 X100 Y80
M30
