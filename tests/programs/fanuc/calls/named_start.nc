%
O1 (a call by name begins at Q)
G21 G90 G17 G54
M98 <PART> Q20
M98 <PART>
(a name that calls itself)
M98 <DEEP>
M30
<PART>
G00 X1.
N20 X1.5
M99
<DEEP>
M98 <DEEP>
M99
%
