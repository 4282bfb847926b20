0 BEGIN PGM BACK MM
; The table has stood at an offset of its preset: PLANE RESET turns it to the zero of the machine.
1 L B+10 FMAX
2 PLANE RESET TURN FMAX
3 END PGM BACK MM
