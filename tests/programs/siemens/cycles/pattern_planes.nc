; A pattern calls a subprogram in another plane; a pattern without a hole calls none; a pattern in the subprogram of
; another one ends that one.
G18 G90 G54 G0 X0 Y50 Z0 F100
MCALL L10
HOLES1(5,7,0,0,10,2)
HOLES2(0,0,20,0,0,0)
X1
MCALL
G17 G0 X0 Y0 Z50
MCALL L20
HOLES1(0,100,0,0,100,2)
MCALL
M30
%_N_L10_SPF
G1 Y-3
G0 Y2
M17
%_N_L20_SPF
MCALL L30
HOLES1(1,2,90,0,4,2)
MCALL
G0 Z60
M17
%_N_L30_SPF
G1 Z-1
G0 Z5
M17
