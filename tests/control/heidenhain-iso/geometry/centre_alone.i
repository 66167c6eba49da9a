%TEST G71 *
; rule: HEIDENHAIN I, J in a block of their own set the centre and move nothing
; expect: to X0 Y0
; expect: to X10 Y10
N10 G00 X+0 Y+0 *
N20 I+10 J+0 *
N30 G02 X+10 Y+10 F200 *
N40 M30 *
N99999999 %TEST G71 *
