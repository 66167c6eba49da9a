%TEST G71 *
; rule: HEIDENHAIN: the last line names the program, and nothing behind it is read
; expect: to X1
N10 G00 X+1 *
N20 M30 *
N99999999 %TEST G71 *
N30 G00 X+2 *
