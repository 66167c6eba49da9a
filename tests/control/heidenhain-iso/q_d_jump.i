%TEST G71 *
; rule: HEIDENHAIN D09: a jump to a label, not read
; expect: alarm  K5018 at 4:5
N10 D09 P01 +Q1 P02 +Q2 P03 5 *
N20 M30 *
N99999999 %TEST G71 *
