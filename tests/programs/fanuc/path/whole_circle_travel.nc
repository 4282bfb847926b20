%
O1 (a circle without end words is checked against the travel, too)
G21 G90 G17 G94 G54
G00 X0. Y0. Z0.
X90.
G02 I20. F100.
G00 X0.
X120.
G00 X0.
M30
%
