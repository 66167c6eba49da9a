%TEST G71 *
; rule: HEIDENHAIN: a G code that there is not
; expect: alarm  K5002 at 4:5
N10 G300 *
N20 M30 *
N99999999 %TEST G71 *
