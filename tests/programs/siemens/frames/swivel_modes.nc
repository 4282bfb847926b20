; Modes of CYCLE800 that are not executed: each is named.
G17 G90 G54 G0 X0 Y0 Z50 F100
CYCLE800(0,"",0,192,0,0,0,10,20)
CYCLE800(0,"",0,128,0,0,0,10,20)
M30
