; The program goes back from the block of a pattern itself, so its other holes are missing.
G17 G90 G54 G0 X0 Y0 Z50 F100
MCALL L10(5)
L20
HOLES1(50,0,0,10,10,2)
MCALL
M30
%_N_L20_SPF
HOLES1(0,0,0,10,10,3) M17
%_N_L10_SPF
PROC L10(REAL D)
G0 Z2
G1 Z=-D
G0 Z2
M17
