0 BEGIN PGM CALLS MM
1 ; TOOL CALL while RL is in force: the radius of the new tool, and another DR, from the next move
2 TOOL CALL 5 Z S3000
3 L X-20 Y-20 Z+5 R0 FMAX M3
4 L Z-5 F500
5 L X+0 Y+0 RL F200
6 L Y+50
7 TOOL CALL 6 Z S3000
8 L X+60
9 TOOL CALL S2000
10 L Y+0 RL
11 TOOL CALL DR+1
12 L X+30
13 L X+0
14 L X-20 Y-20 R0
15 ; the side has ended, so nothing is reported
16 TOOL CALL 5 Z S3000
17 L X+0 Y+0 RL
18 L Y+50
19 L X-20 R0 FMAX
20 M30
21 END PGM CALLS MM
