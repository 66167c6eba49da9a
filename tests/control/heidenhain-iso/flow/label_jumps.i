%TEST G71 *
; rule: HEIDENHAIN D09 to D12: jumps to labels if the first value is equal to, not equal to, greater or less than the second
; expect: Q1=4
; expect: Q2=1
; expect: Q3 unset
; expect: Q4=1
N10 D00 Q1 P01 +0 *
N20 G98 L1 *
N30 D01 Q1 P01 +Q1 P02 +1 *
N40 D12 P01 +Q1 P02 +4 P03 1 *
N50 D10 P01 +Q1 P02 +4 P03 2 *
N60 Q2=1 *
N70 G98 L2 *
N80 D11 P01 +Q1 P02 +3.5 P03 3 *
N90 Q3=1 *
N100 G98 L3 *
N110 D09 P01 +Q1 P02 +5 P03 99 *
N120 Q4=1 *
N130 M30 *
N99999999 %TEST G71 *
