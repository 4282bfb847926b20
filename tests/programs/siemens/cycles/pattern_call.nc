; A pattern of holes calls a subprogram at each position; one without M17 does not come back.
G17 G90 G54 G0 X0 Y0 Z50 F100
MCALL L10(5)
HOLES1(0,0,0,10,10,3)
HOLES2(0,0,20,0,0,2)
X1 Y1
MCALL
HOLES1(0,0,0,10,10,3)
MCALL NOEND
HOLES1(0,0,0,10,10,3)
MCALL
M30
%_N_L10_SPF
PROC L10(REAL D)
G0 Z2
G1 Z=-D
G0 Z2
M17
%_N_NOEND_SPF
G1 Z-9
G0 Z9
