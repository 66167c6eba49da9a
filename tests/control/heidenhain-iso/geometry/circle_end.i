%TEST G71 *
; rule: HEIDENHAIN: the end of a circle is not on it
; expect: to X0 Y0
; expect: alarm  K5220 at 6:19
N10 G00 X+0 Y+0 *
N20 G02 X+10 Y+10 I+10 J+1 F200 *
N30 M30 *
N99999999 %TEST G71 *
