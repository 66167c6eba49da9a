%TEST G71 *
; rule: HEIDENHAIN R: the centre that stays does not matter for it
; expect: to X0 Y0
; expect: to X10 Y10
N10 G00 X+0 Y+0 *
N20 I+50 J+50 *
N30 G03 X+10 Y+10 R+10 F200 *
N40 M30 *
N99999999 %TEST G71 *
