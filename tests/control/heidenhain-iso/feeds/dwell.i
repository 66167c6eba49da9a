%TEST G71 *
; rule: HEIDENHAIN G04: F is the dwell in seconds
; expect: to X1
; expect: to X2
N10 G00 X+1 *
N20 G04 F0.5 *
N30 X+2 *
N40 M30 *
N99999999 %TEST G71 *
