0 BEGIN PGM CALLS MM
1 TOOL CALL 3 Z S1000
2 L X+0 Y+0 Z+5 R0 FMAX
3 ; no cycle to call: by CYCL CALL, M89 and a pattern
4 CYCL CALL
5 L X+1 FMAX M89
6 L X+2 FMAX
7 PATTERN DEF POS1 (X+10 Y+10 Z+0) POS2 (X+40 Y+10 Z+8)
8 CYCL CALL PAT FMAX
9 ; from Z5 to the second set-up clearance: Z20, and Z28 at the second point, which lies 8 higher
10 CYCL DEF 201 REAMING Q200=2 Q201=-15 Q206=100 Q203=0 Q204=20
11 CYCL CALL PAT FMAX
12 ; upwards from Z-30: the second set-up clearance is Z-20, and Z-12 at the second point, so the tool stays at Z-30
13 CYCL DEF 201 REAMING Q200=2 Q201=+15 Q206=100 Q203=0 Q204=20
14 L Z-30 FMAX
15 CYCL CALL PAT FMAX
16 ; a cycle that is not executed is reported once
17 CYCL DEF 262 THREAD MILLING Q335=10
18 CYCL CALL
19 CYCL CALL
20 END PGM CALLS MM
