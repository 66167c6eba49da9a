%TEST G71 *
; rule: HEIDENHAIN: a label that a jump or a call names must be there
; expect: alarm  K5431 at 5:27
N10 Q1=1 *
N20 D09 P01 +1 P02 +1 P03 8 *
N30 M30 *
N99999999 %TEST G71 *
