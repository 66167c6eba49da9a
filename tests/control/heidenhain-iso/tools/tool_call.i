%TEST G71 *
; rule: HEIDENHAIN T with the axis: the tool is changed at once
; expect: to X1
N10 G99 T1 L+0 R+5 *
N20 T1 G17 S2500 *
N30 G00 X+1 *
N40 M30 *
N99999999 %TEST G71 *
