0 BEGIN PGM FURTHER_AXES MM
; The travel of U is empty: each move shows its position. 20 of the preset + 5 = 25.
1 L X+0 Y+0 Z+50 U+5 R0 FMAX
; 25 + 2.5 = 27.5
2 L IU+2.5 V+90 FMAX
; the machine: 7
3 L U+7 FMAX M91
4 CC X+10 Y+0
; a helix beside: 3 + 20 = 23
5 C X+20 Y+0 DR+ F100 U+3
6 FN 0: Q1 = +3
; -3 + 20 = 17; the block begins with an axis
7 U-Q1
8 L IX+1 IU-1 F100
; not executed
9 TRANS DATUM AXIS X+1 U+5
10 CYCL DEF 7.0 DATUM SHIFT
11 CYCL DEF 7.1 U+5
12 L W+3
13 TOOL CALL 1 U S100
14 STOP M30
99 END PGM FURTHER_AXES MM
