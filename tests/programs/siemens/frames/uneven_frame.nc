; A settable frame whose scales differ: G41 in it is reported once, until G40 and G41 again.
G17 G90 G54 G0 X0 Y0 Z10 F100 S1000 M3
T1 M6
G1 G41 X10 Y0
X10 Y30
X40
G40 X50 Y50
G41 X10 Y0
X10 Y30
G40 X50 Y50
; The same in a programmable frame.
G500
SCALE X2
G41 X10 Y0
X10 Y30
G40 X50 Y50
G41 X10 Y0
X10 Y30
G40 X50 Y50
M30
