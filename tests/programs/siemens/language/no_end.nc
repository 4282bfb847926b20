; A program that ends with its file, and TRAORI twice on a machine that has no kinematics.
G17 G90 G54
TRAORI
G1 X10 F500
TRAFOOF
TRAORI
X0
TRAFOOF
G0 Z50
