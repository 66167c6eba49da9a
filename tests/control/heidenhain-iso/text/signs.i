%TEST G71 *
; rule: HEIDENHAIN DIN/ISO: coordinates have their sign, blocks end with *
; expect: to X10 Y-5
N10 G00 X+10 Y-5 *
N20 M30 *
N99999999 %TEST G71 *
