%
O6830 (PLANES THAT THE CONTROL OR THE MACHINE REFUSES)
N1 G90 G17 G21 G54 G69 G00 X0. Y0. Z0. A0.
(a vector without a number)
N2 G68.2 P3 X0. Y0. Z0. I1. J0. K0.
N3 X1.
(A alone cannot lean the tool so)
N4 G68.2 X0. Y0. Z0. I30. J90. K0.
N5 G53.1
N6 X1. Y2. Z3.
N7 G69
(G92.1 of a rotary axis, with a value)
N8 G92.1 A10.
N9 M30
%
