; A programmable frame that is rotated by more than 45 degrees is read as a rotation, not as a mirror image.
G17 G90 G54 G0 X0 Y0 Z10
ROT Y80
R1=$P_PFRAME[Y,RT] R2=$P_PFRAME[X,MI]
ROT Y-80
R3=$P_PFRAME[Y,RT] R4=$P_PFRAME[X,MI]
ROT
X=R1 Y=R2 Z=10
X=R3 Y=R4
M30
