%TEST G71 *
; rule: HEIDENHAIN polar coordinates need a pole, both of its coordinates
; expect: to X5 Y7 rapid
; expect: alarm  K5780 at 7:5
N10 G00 G90 X+5 Y+7 *
N20 I+10 *
N30 G11 R+10 H+0 F200 *
N40 M30 *
N99999999 %TEST G71 *
