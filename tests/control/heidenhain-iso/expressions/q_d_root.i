%TEST G71 *
; rule: HEIDENHAIN D05: no root of a negative value
; expect: alarm  K5421 at 4:16
N10 D05 Q1 P01 -5 *
N20 M30 *
N99999999 %TEST G71 *
