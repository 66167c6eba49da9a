%TEST G71 *
; rule: HEIDENHAIN G79 without a cycle definition
; expect: to X1
; expect: alarm  K5292 at 6:5
N10 G00 X+1 *
N20 G79 *
N30 M30 *
N99999999 %TEST G71 *
