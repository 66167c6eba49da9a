%TEST G71 *
; rule: HEIDENHAIN Q100 to Q199: the control's own
; expect: alarm  K5018 at 4:5
N10 Q113=1 *
N20 M30 *
N99999999 %TEST G71 *
