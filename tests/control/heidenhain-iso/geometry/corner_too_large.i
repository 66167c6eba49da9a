%TEST G71 *
; rule: HEIDENHAIN a rounding that does not fit is an alarm
; expect: alarm  K5314 at 5:5
N10 G01 G90 X+40 F100 *
N20 G25 R50 *
N30 Y+30 *
N40 M30 *
N99999999 %TEST G71 *
