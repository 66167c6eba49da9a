%TEST G71 *
; rule: HEIDENHAIN formulas: brackets, powers, products before sums
; expect: Q1=14
; expect: Q2=20
; expect: Q3=8
N10 Q1=2+3*4 *
N20 Q2=(2+3)*4 *
N30 Q3=2^3 *
N40 M30 *
N99999999 %TEST G71 *
