%TEST G71 *
; rule: HEIDENHAIN R: a negative radius is the longer arc
; expect: to X0 Y0
; expect: to X10 Y10
; expect: to X0 Y0
N10 G00 X+0 Y+0 *
N20 G02 X+10 Y+10 R+10 F200 *
N30 X+0 Y+0 R-10 *
N40 M30 *
N99999999 %TEST G71 *
