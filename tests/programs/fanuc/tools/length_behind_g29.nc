%
O1 (the length of G43 under G91 is travelled once: G29 goes to a position in it)
G21 G17 G90 G54 G94
G00 X0. Y0. Z50.
G91 G28 Z0
T1 M06
G43 H1
G90 G29 Z50.
G91 G00 Z-5.
M30
%
