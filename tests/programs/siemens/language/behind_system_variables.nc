; Words behind an assignment without effect are executed.
G17 G71 G90 D0
$AC_TIMER[1]=0 G0 X5
R1=1 $AC_TOTAL_PARTS=$AC_TOTAL_PARTS + 1 R2=6
Y=R2
$TC_TP2[1]="A B" Z3
$MA_X[1]=3 X8
; REAL values are compared with a relative equality of 1E-12.
R1=0
LL: R1=R1+0.1
X=R1
IF R1<1 GOTOB LL
IF R1==1
Y1
ENDIF
IF R1<>1
Y2
ENDIF
IF R1>1
Y3
ENDIF
IF R1>=1
Y4
ENDIF
IF R1<=1
Y5
ENDIF
; Positions and the feed are inches under G700.
G700
G1 X2 Y3 Z4 F10
X=$P_EP[X] Y=$AA_IW[Y] Z=$AA_IM[Z] F=$P_F
$AC_TOTAL_PARTS=1 M30
X100
