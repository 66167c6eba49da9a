%TEST G71 *
; rule: HEIDENHAIN G99: L is the length of a tool there, not a call
; expect: path x5f500
N10 G99 T5 L50 R+3 *
N20 G99 T6 L+50 R+3 *
N30 S1000 M03 *
N40 G01 X+5 F500 *
N50 M30 *
N99999999 %TEST G71 *
