%TEST G71 *
; rule: HEIDENHAIN Q parameters: X+Q1, X-Q1
; expect: Q1=5
; expect: to X5
; expect: to X-5
N10 Q1=+5 *
N20 G00 X+Q1 *
N30 X-Q1 *
N40 M30 *
N99999999 %TEST G71 *
