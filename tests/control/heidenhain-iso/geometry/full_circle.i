%TEST G71 *
; rule: HEIDENHAIN: an arc to where it begins is a full circle
; expect: to X0 Y0
; expect: to X0 Y0
N10 G00 X+0 Y+0 *
N20 G03 X+0 Y+0 I+5 J+0 F200 *
N30 M30 *
N99999999 %TEST G71 *
