; The base frame acts before any code of a settable frame.
G0 X1 Y2 Z3
; Y and Z mirrored are half a turn about X, counted from -180 (not reached) to 180.
$P_PFRAME=CMIRROR(Y,Z)
R1=$P_PFRAME[X,RT]
TRANS
G0 X=R1 Y1
M30
