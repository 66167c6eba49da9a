%TEST G71 *
; rule: HEIDENHAIN G98 L: a label, not read
; expect: alarm  K5018 at 4:5
N10 G98 L1 *
N20 M30 *
N99999999 %TEST G71 *
