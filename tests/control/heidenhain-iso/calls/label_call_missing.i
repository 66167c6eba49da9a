%TEST G71 *
; rule: HEIDENHAIN: a label that a call names must be there
; expect: alarm  K5432 at 4:6
N10 L8,0 *
N30 M30 *
N99999999 %TEST G71 *
