%TEST G70 *
; rule: HEIDENHAIN: the units of a program stand in its head, behind its name
; expect: to X25.4 Y0
N10 G00 X+1 Y+0 *
N20 M30 *
N99999999 %TEST G70 *
