; A frame that is refused is not written in part: X5 is 5 of the machine.
$P_UIFR[1]=CFINE(X,1):CROT(Z,600000000):CROT(Z,600000000)
G54
G0 X5
M30
