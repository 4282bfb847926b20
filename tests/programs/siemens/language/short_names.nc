; A name that the program has defined is its variable, also where it looks like an address.
DEF REAL Z
DEF REAL X1[3]
G17 G71 G90 G0 X0 Y0 Z50 D0
Z=7
X=Z
X1[0]=12.5 X1[2]=3
Y=X1[0]+X1[2]
SUB1(12)
M30
%_N_SUB1_SPF
PROC SUB1(REAL A)
A=A+1
X=A
M17
