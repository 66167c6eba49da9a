%TEST G71 *
; rule: HEIDENHAIN: two G codes of one group
; expect: alarm  K5008 at 4:9
N10 G00 G01 X+1 *
N20 M30 *
N99999999 %TEST G71 *
