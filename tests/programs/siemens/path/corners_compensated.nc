; Corners under G41 that do not fit stay sharp, and are said at their word.
G17 G710 G90 G94 G0 X-10 Y-10 Z5
T1 M6
S1000 M3 F600
G41 G1 X0 Y0 Z-1
Y30 RND=60
X30 CHF=50
Y0 CHR=2
X0
G40 X-10 Y-10
M30
