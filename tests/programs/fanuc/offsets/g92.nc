O9201 (G92 AND G92.1)
G10 L2 P1 X100. Y50. Z-200.
G10 L2 P2 X300. Y50. Z-210.
G90 G54 G00 X10. Y20. Z30.
(the place is X0 Y0 Z50 from here on, in G54 and in G55)
G92 X0 Y0 Z50.
X5.
Z10.
G55 X5.
Y1.
(an axis alone, and the words are coordinates under G91)
G91 G92 X100.
X1.
G90 X100.
(with a tool length the tip counts, also before a move)
G43 H1
G92 Z5.
Z6.
G49
(G52 ends on the axis that G92 names)
G52 X10. Y10.
X0. Y0.
G92 X0
X1. Y1.
(G92.1 ends the shift of X, then of all axes)
G92.1 X0
X1. Y1.
G92.1
G54 X1. Y1. Z1.
(a limit of the spindle speed)
G92 S3000
(inside a rotation it works, and is a warning)
G68 X0 Y0 R90.
X10. Y0.
G92 X0 Y0
X5.
G69
G92.1 X0 Y0 Z0
X0. Y0. Z0.
M30
