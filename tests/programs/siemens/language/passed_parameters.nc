; $P_SUBPAR[n]: the call has given parameter n
G0 X0 Y0
PARK(5)
PARK(6,7)
PARK(,8)
M30
%_N_PARK_SPF
PROC PARK(REAL A=1, REAL B=2)
; X: 10 where A is given, Y: 20 where B is given
G0 X=A+10*$P_SUBPAR[1] Y=B+20*$P_SUBPAR[2]
IF $P_SUBPAR[3]==FALSE
G0 Z=A
ENDIF
M17
