%
O1 (G28 ends the length of G43 under G91 before a Z has travelled it)
G21 G17 G90 G54 G94
G00 X0. Y0. Z50.
G91 G43 H1
G28 X0 Y0
Z-5.
M30
%
