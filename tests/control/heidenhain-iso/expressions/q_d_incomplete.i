%TEST G71 *
; rule: HEIDENHAIN D01 has two values
; expect: alarm  K5402 at 4:19
N10 D01 Q1 P01 +5 *
N20 M30 *
N99999999 %TEST G71 *
