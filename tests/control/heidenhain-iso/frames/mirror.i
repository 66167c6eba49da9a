%TEST G71 *
; rule: HEIDENHAIN G28: mirrors the named axes, without an axis ends it
; expect: to X-10 Y5
; expect: to X10 Y5
N10 G28 X+0 *
N20 G00 X+10 Y+5 *
N30 G28 *
N40 X+10 Y+5 *
N50 M30 *
N99999999 %TEST G71 *
