%TEST G71 *
; rule: HEIDENHAIN: subprograms inside each other, labels by name; G98 L0 that nobody has called does nothing
; expect: Q1=6
; expect: Q2=2
N10 Q1=0 *
N15 G98 L0 *
N20 L"OUTER",0 *
N30 L"OUTER",0 *
N40 M30 *
N50 G98 L"OUTER" *
N60 Q2=Q2+1 *
N70 L10,0 *
N80 Q1=Q1+1 *
N90 G98 L0 *
N100 G98 L10 *
N110 Q1=Q1+2 *
N120 G98 L0 *
N99999999 %TEST G71 *
