0 BEGIN PGM INCHES INCH
1 ; Q108 and Q114 hold inches in an inch program: radius 1 and 0.1, length 2.
2 TOOL DEF 7 L+2 R+1
3 TOOL CALL 7 Z DR+0.1
4 L X+Q108 Y+Q114 F100
5 M30
6 END PGM INCHES INCH
