%TEST G71 *
; rule: HEIDENHAIN an angle belongs to the codes of polar motions
; expect: to X5 Y7 line
; expect: alarm  K5781 at 7:5
N10 I+10 J+10 *
N20 G01 G90 X+5 Y+7 F200 *
N30 H+30 *
N40 M30 *
N99999999 %TEST G71 *
