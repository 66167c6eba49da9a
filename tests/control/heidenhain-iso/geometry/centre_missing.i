%TEST G71 *
; rule: HEIDENHAIN: circle centre undefined
; expect: to X0 Y0
; expect: alarm  K5223 at 6:5
N10 G00 X+0 Y+0 *
N20 G02 X+10 Y+10 F200 *
N30 M30 *
N99999999 %TEST G71 *
