%TEST G71 *
; rule: HEIDENHAIN Q200 to Q1199 are free where a cycle does not use them; Q108 is the radius of the tool
; expect: Q300=7
; expect: Q1=5
N10 T1 G17 S2500 *
N20 Q300=+7 *
N30 Q1=Q108 *
N40 M30 *
N99999999 %TEST G71 *
