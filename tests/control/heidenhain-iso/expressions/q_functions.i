%TEST G71 *
; rule: HEIDENHAIN formulas: functions
; expect: Q1=0.5
; expect: Q2=4
; expect: Q3=9
; expect: Q4=2
N10 Q1=SIN(30) *
N20 Q2=SQRT(16) *
N30 Q3=SQ(3) *
N40 Q4=INT(2.7) *
N50 M30 *
N99999999 %TEST G71 *
