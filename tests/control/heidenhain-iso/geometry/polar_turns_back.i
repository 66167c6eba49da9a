%TEST G71 *
; rule: HEIDENHAIN under G91 the angle of an arc of more than a turn has the sign of its direction
; expect: to X20 Y0 rapid
; expect: alarm  K5302 at 7:5
N10 G00 G90 X+20 Y+0 *
N20 I+0 J+0 *
N30 G13 G91 H-450 F200 *
N40 M30 *
N99999999 %TEST G71 *
