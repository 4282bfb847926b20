%
O1 (a length is travelled along Z of the machine, whatever G51 and G51.1 do to Z)
G21 G17 G90 G54 G94 F100
G00 X0 Y0 Z100.
G51 X0 Y0 Z0 P2000
G91 G43 H1
G01 Z-10. (20 and the length)
Z-10.
G50
G49 Z-10.
G51.1 Z0
G43 H1 Z-10. (up by 10, and the length)
G50.1 Z0
G49
G90 Z0
M30
%
