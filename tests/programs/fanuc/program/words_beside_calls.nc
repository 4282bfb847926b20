%
O1 (a name beside P of a call, and P of G05.1, are reported)
G21 G90 G17 G94 G54
M98 P2 <PART>
G05.1 Q1 P7
G05.1 Q1.5
(the first move of a rotary axis counts from 0)
G93 G01 A90. F2.
A180. F2.
G94
(an offset without an axis)
G45 D1
M30
O2
G00 X1.
M99
%
