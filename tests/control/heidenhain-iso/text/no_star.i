%TEST G71 *
; rule: HEIDENHAIN DIN/ISO: a file may lack the * at the end of a line
; expect: to X10
N10 G00 X+10
N20 M30
N99999999 %TEST G71 *
