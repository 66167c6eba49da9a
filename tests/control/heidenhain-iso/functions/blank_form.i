%TEST G71 *
; rule: HEIDENHAIN G30, G31: the blank moves nothing
; expect: to X1
N10 G30 G17 X+0 Y+0 Z-40 *
N20 G31 G90 X+100 Y+100 Z+0 *
N30 G00 X+1 *
N40 M30 *
N99999999 %TEST G71 *
