; G53 suppresses the settable frame and keeps the base frame, of rotary axes, too.
G17 G90 G54 G0 X0 Y0 Z50 C0
G53 X10 C45
G153 X10 C45
M30
