%TEST G71 *
; rule: HEIDENHAIN L1,3: the blocks between the label and the call three times more
; expect: path x5f500 x10 x15 x20 y9
N10 T1 G17 S1000 M03 *
N20 G01 F500 *
N30 G98 L1 *
N40 G91 X+5 *
N50 L1,3 *
N60 G90 Y+9 *
N70 M30 *
N99999999 %TEST G71 *
