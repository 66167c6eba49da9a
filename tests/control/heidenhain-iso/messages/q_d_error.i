%TEST G71 *
; rule: HEIDENHAIN D14: an error message of the program's own
; expect: alarm 1000 K5450 at 4:5
N10 D14 P01 1000 *
N20 M30 *
N99999999 %TEST G71 *
