%TEST G71 *
; rule: HEIDENHAIN G91: I and J count from the last position
; expect: to X5 Y5
; expect: to X15 Y15
N10 G00 X+5 Y+5 *
N20 G91 G02 X+10 Y+10 I+10 J+0 F200 *
N30 G90 M30 *
N99999999 %TEST G71 *
