0 BEGIN PGM START MM
1 ; The rotation of preset 0 is in force from the start; preset 1 has none.
2 L X+10 Y+20 Z+5 R0 FMAX
3 CYCL DEF 247 DATUM SETTING Q339=+1
4 L X+10 Y+20 FMAX
5 M30
6 END PGM START MM
