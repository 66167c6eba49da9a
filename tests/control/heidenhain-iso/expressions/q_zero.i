%TEST G71 *
; rule: HEIDENHAIN formulas: division by zero
; expect: alarm  K5420 at 4:9
N10 Q1=1/0 *
N20 M30 *
N99999999 %TEST G71 *
