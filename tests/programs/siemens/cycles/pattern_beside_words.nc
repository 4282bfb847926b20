; Words of a move beside a pattern are not executed: the tool stands at the last position of the pattern.
G17 G90 G54 G0 X0 Y50 Z10 F100
MCALL CYCLE81(10,0,2,-5)
HOLES1(5,7,0,0,10,2) X3
G0 Z20
; the same under MCALL of a subprogram
MCALL L10
HOLES1(5,7,0,0,10,2) Y3 Z4
MCALL
M30
%_N_L10_SPF
G91 G1 Z-3
G0 Z3
G90
M17
