%TEST G71 *
; rule: HEIDENHAIN a chamfer has a side before it
; expect: alarm  K5312 at 4:5
N10 G24 R5 *
N20 G01 G90 X+40 F100 *
N30 M30 *
N99999999 %TEST G71 *
