; Chamfers and roundings: a square of 40 with a different corner each time.
G17 G710 G90 G94 G0 X0 Y0 Z5
S1000 M3 F600
G1 Z-1
X40 CHR=4
Y40 CHF=4
X0 RND=5
Y0
; All corners with the same radius, also between line and arc; the last one at a rapid stays.
RNDM=3
G1 X40
Y20
G2 X60 Y20 CR=10
G1 Y0
X40
RNDM=0
X0
; Beside the contour.
G0 X-10 Y-10
T1 M6
G41 G1 X0 Y0
Y30 RND=6
X30
G40 Y60
; A corner of 60 degrees: 4 long, legs of 4.
G1 X0 Y0
X40 CHF=4
X20 Y34.641016
; Nothing fits, twice; FRC; less than 0.
X0 Y0
X2 RND=50 FRC=100
Y2
X10 RND=-1
Y10 CHR=1 RND=1
X0
M30
