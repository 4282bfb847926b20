G21 G90 G94 (a G66 of one format, and the G67 of the other)
G00 X0. Y0. Z0.
G66 P9210
X1.
M98 P9220
X2.
M98 P9230
(begins behind the mark of its file)
M98 P9240 H20
(this file is in ISO format still; its next call begins nowhere)
M98 P9240 H99
X9.
M30
