; G153, G53 and SUPA in a swivelled plane: the length lies along Z of the machine, whose table has turned the workpiece.
G17 G90 G54 G0 X0 Y0 Z100 F200 S500 M3
T1 M6
G153 G0 X1 Y2 Z0
TRANS X100
CYCLE800(0,"T",0,57,0,0,0,30,0,0,0,0,0,-1)
G153 G0 X3 Y4 Z0
SUPA G0 X1 Y2 Z0 D0
D1
G0 X10 Y20 Z30
G53 G0 Z100
CYCLE800()
G0 X10 Y20 Z30
M30
