O6803 (PARAMETERS 5400 = 1, 5410 = 30 DEGREES, 1202 = 8)
G90 G54 G00 X0. Y0.
(no R: parameter 5410)
G68 X0 Y0
X10. Y0.
(R is added under G91)
G91 G68 X0 Y0 R60.
G90 X10. Y0.
(and is the angle itself under G90)
G68 X0 Y0 R60.
X10. Y0.
G69
G52 X5.
X0.
(the reset that goes with M30 clears G52)
M30
