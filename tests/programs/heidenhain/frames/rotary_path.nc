0 BEGIN PGM ROT MM
1 L X+0 Y+0 Z+100 R0 FMAX
2 L C+350 R0 FMAX
; 10 degrees further on, the shortest way
3 M126
4 L C+10 R0 FMAX
5 L C+350 FMAX
; never through 0: 340 degrees back, and forth
6 L C+10 F1000 M127
7 L C+350
8 L C-30
9 L IC+20
10 M126
11 M94 C
12 L C+10
; an increment goes as far as it says
 L IC+300
 L IC-360
13 CYCL DEF 332 TUNING ~
 Q239=+0.03 ;TOLERANCE
14 CYCL DEF 392 SETTINGS ~
 Q240=+1 ;MODE
15 M30
16 END PGM ROT MM
