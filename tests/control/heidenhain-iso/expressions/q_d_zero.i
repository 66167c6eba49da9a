%TEST G71 *
; rule: HEIDENHAIN D04: division by zero
; expect: alarm  K5420 at 4:16
N10 D04 Q1 P01 +5 P02 +0 *
N20 M30 *
N99999999 %TEST G71 *
