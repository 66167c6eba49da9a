%TEST G71 *
; rule: HEIDENHAIN G54: shift of the zero point, an axis that is not named keeps its own
; expect: to X15 Y5
; expect: to X15 Y8
; expect: to X5 Y5
N10 G54 X+10 *
N20 G00 X+5 Y+5 *
N30 G54 Y+3 *
N35 X+5 Y+5 *
N40 G54 X+0 Y+0 Z+0 *
N50 X+5 Y+5 *
N60 M30 *
N99999999 %TEST G71 *
