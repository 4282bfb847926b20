%
O1 (macro statements and calls between the moves are no blocks without a move)
(D1 has the radius 5)
G21 G17 G90 G00 X0 Y0 Z0
G41 D1 G01 X10. Y10. F100
Y50.
#1=1
#2=#1+1
IF[#2EQ3]GOTO99
#3=70.
#4=4
X-30.
M98 P100
(the call is not counted, two M codes are)
M08
M09
X-60.
M98 P100 M08
M09
M08
Y-20.
G40 X-80.
M30
O100
#5=5
Y90.
M99
%
