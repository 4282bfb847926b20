; User data (GUD) with types, macros of the machine, and frames; user_data.xml has the tables.
N10 G54 G0 X0 Y0 Z0
; COUNT is an INT with the limits 0 to 10: 4 + 2.6 rounds to 7, 11 is refused.
N20 COUNT=COUNT+2.6
N30 COUNT=11
N40 X=COUNT
; STOCK[0] is 0.5 as the whole array, STOCK[1] 0.25 by its row: X = 0.75.
N50 X=STOCK[0]+STOCK[1]
N60 STOCK[0]=SET(1,2)
N70 X=STOCK[0]*10+STOCK[1]
N80 IF LABEL=="A;B"
N90 LABEL="LONGER TEXT"
N100 LABEL="NEXT"
N110 ENDIF
N120 IF LABEL=="NEXT"
N130 AX[WAY]=5
N140 ENDIF
N150 WAY=Y
N160 AX[WAY]=6
; FIX is X5 turned by 90 degrees; CTRANS(X,1) behind it lies along the turned X: X5 Y1. X2 goes to X5 Y1+2=3.
N170 $P_UIFR[1]=FIX:CTRANS(X,1)
N180 G54 X2 Y0
; 10 + 1 * 2 = 12 in X by the scale; Y is mirrored: -1 * 1.
N190 $P_UIFR[1]=CTRANS(X,COUNT+3):CSCALE(X,2):CMIRROR(Y)
N200 G54 X1 Y1
N210 DEF FRAME KEPT=$P_UIFR[1]
N220 $P_UIFR[1]=CTRANS()
N230 G54 X1 Y1
N240 $P_UIFR[2]=KEPT
N250 G55 X1 Y1
; Macros of the table: G301 is G0 SUPA Z50, DEEP is -2.5, AGAIN names itself, CHAIN names another macro.
N260 G301
N270 Z=DEEP*2
N280 AGAIN
N290 CHAIN
N300 $A_OUT[3]=1
N310 IF $A_OUT[3]
N320 X9
N330 ENDIF
N340 M30
