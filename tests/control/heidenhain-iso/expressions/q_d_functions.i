%TEST G71 *
; rule: HEIDENHAIN D00 to D08, D13: a parameter from one or two values, each a number or a parameter
; expect: Q1=60
; expect: Q2=-65
; expect: Q3=5
; expect: Q4=30
; expect: Q5=2
; expect: Q6=3
; expect: Q7=0.5
; expect: Q8=0.5
; expect: Q9=5
; expect: Q10=135
; expect: to X+5
N10 D00 Q1 P01 +60 *
N20 D01 Q2 P01 -Q1 P02 -5 *
N30 D02 Q3 P01 +Q1 P02 +55 *
N40 D03 Q4 P01 +Q3 P02 +6 *
N50 D04 Q5 P01 +Q1 P02 +Q4 *
N60 D05 Q6 P01 +9 *
N70 D06 Q7 P01 +Q4 *
N80 D07 Q8 P01 +Q1 *
N90 D08 Q9 P01 +3 P02 +4 *
N100 D13 Q10 P01 +1 P02 -1 *
N110 G00 X+Q9 *
N120 M30 *
N99999999 %TEST G71 *
