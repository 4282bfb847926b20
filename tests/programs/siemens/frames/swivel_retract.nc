; CYCLE800 with a retract: Z; Z, then X and Y; along the tool to the end of the travel; along the tool by 10.
G17 G90 G500 G0 X10 Y20 Z0
CYCLE800(1,"",0,57,0,0,0,30,0,0,0,0,0,-1)
G0 X0 Y0
SUPA Z0
CYCLE800(2,"",0,57,0,0,0,0,0,0,0,0,0,-1)
SUPA Z0
CYCLE800(4,"",0,57,0,0,0,30,0,0,0,0,0,-1)
SUPA Z0
CYCLE800(5,"",0,57,0,0,0,0,0,0,0,0,0,-1,10)
M30
