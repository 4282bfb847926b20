; another D, D0 and another tool while G41 is in force: the radius changes over the next move
T1 D1 M6
G0 X0 Y0 Z10
G41 G1 X10 F100
X20
D2
X30
X40 D1
X50
D0
X60
T2 M6
X70
G2 X80 Y-10 I0 J-10 D2
G1 Y-20
G40 X90
D1 X100
M30
