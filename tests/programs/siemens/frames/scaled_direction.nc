; A settable frame turns and mirrors the direction of the tool, and does not scale it: 45 degrees, not 63.
G17 G90 G54 G0 X0 Y0 Z50 T1 M6
TRAORI
G1 F1000 X0 Y0 Z10 A3=0 B3=1 C3=1
X1 Y1 Z5
TRAFOOF
M30
