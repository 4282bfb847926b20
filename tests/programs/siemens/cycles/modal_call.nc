; MCALL of a subprogram: after each move of this program, not of the called one.
G0 X0 Y0 Z10 F100
MCALL TAP(2,R1)
X10
M8
Y10
G1 X0
MCALL
Y0
M30
%_N_TAP_SPF
PROC TAP(REAL DEPTH, REAL COUNT)
G0 Z=-DEPTH
Z10
M17
