G21 G90
G00 X1. Y2.
o100 sub
G00 X10.
o100 endsub
o100 call
M02
