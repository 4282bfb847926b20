0 BEGIN PGM FEEDS MM
1 ; F AUTO is the feed of the TOOL CALL in its own mode, whatever FU stands between.
2 TOOL DEF 5 L+0 R+5
3 TOOL DEF 6 L+0 R+3
4 TOOL CALL 5 Z S2500 F500
5 L X+0 Y+0 FU0.2
6 L X+10 F AUTO
7 L X+20 F100
8 TOOL CALL 6 Z S1000 FU0.1
9 L X+40 F100
10 L X+50 F AUTO
11 ; R0 behind the radius of CR is the side, R0.5 the radius of an approach.
12 CR X+80 Y+0 R+20 DR- R0 F100
13 L X-20 Y-20 R0
14 APPR LCT X+0 Y+0 R0.5 RL F300
15 L Y+50
16 DEP LCT X-20 Y+60 R0.5
17 ; DR without a tool belongs to the tool in the spindle: Q108 is its radius and DR.
18 TOOL CALL DR+2
19 L X+Q108 F100
20 M30
21 END PGM FEEDS MM
