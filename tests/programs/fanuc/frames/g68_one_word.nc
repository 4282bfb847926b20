O1 (in the second block after G68 a missing word keeps its program coordinate)
G21 G90 G94 G17 G40 G49 G80 G54
G00 X10. Y10. Z5.
G68 X0 Y0 R90.
G00 X20. Y10.
G60 X30.
G69
M30
