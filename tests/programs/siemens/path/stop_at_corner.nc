; M0 between two moves of a contour: the control has worked up the next move, so the corner is as without the stop.
G17 G710 G90 G94 G0 X-20 Y-20 Z5
T1 M6
S1000 M3 F600
G41 G1 X0 Y0
X30
M0
Y-30
; An inner corner, with the stop in the block of the move and a dwell behind it.
X60 M0
G4 F1
; A rounding.
Y-60 RND=5
M0
X90
G40 X110
M30
