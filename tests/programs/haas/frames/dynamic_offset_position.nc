%
O1 (the work position of G254 counts from the dynamic offset)
G21 G90 G94 G17
G00 G54 X0. Y0. Z50.
C90.
G254
X0. Y0.
#1=#5041
X#1 (stays)
G255
M30
%
