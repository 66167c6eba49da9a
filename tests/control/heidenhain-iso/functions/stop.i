%TEST G71 *
; rule: HEIDENHAIN G38: stops the program
; expect: to X1
; expect: stop
; expect: to X2
N10 G00 X+1 *
N20 G38 *
N30 X+2 *
N40 M30 *
N99999999 %TEST G71 *
