%TEST G71 *
; rule: HEIDENHAIN G72: factor F, 1 ends it
; expect: to X20 Y10
; expect: to X10 Y5
N10 G72 F2 *
N20 G00 X+10 Y+5 *
N30 G72 F1 *
N40 X+10 Y+5 *
N50 M30 *
N99999999 %TEST G71 *
