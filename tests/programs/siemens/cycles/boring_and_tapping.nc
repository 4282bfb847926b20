; The worked lists of CYCLE84, CYCLE86, CYCLE87 and CYCLE89: X30 Y20, start at Z50.
G17 G710 G90 G94 G0 X30 Y20 Z50
S1000 M3 F200
CYCLE84(50,0,4,-15,,0.3,3,,1.5,0,500,800)
CYCLE86(50,0,2,-20,,0.2,3,-1,-1,1,45)
CYCLE89(50,0,2,-20,,0.2)
CYCLE87(50,0,2,-20,,3)
CYCLE88(50,0,2,-20,,0.2,4)
; As posts write them: all parameters of the newer control.
M3
CYCLE84(50,0,4,,15,0,5,,1.25,0,400,400,0,1,0,1,6,1,"","","",0,1,1001001)
CYCLE840(50,0,4,-15,,0,4,3,11,,1.5)
; A left-hand thread under G18: along Y.
G18 G0 X0 Y50 Z0
MCALL CYCLE84(50,0,4,-15,,,3,-6,,90,300)
X10
X20 Z5
MCALL
M30
