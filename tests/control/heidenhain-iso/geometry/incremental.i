%TEST G71 *
; rule: HEIDENHAIN G91: distances until G90
; expect: to X10 Y5
; expect: to X15 Y5
; expect: to X0 Y5
N10 G00 G90 X+10 Y+5 *
N20 G91 X+5 *
N30 G90 X+0 *
N40 M30 *
N99999999 %TEST G71 *
