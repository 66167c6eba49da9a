%TEST G71 *
; rule: HEIDENHAIN G24: a chamfer between the blocks before and behind it, with a feed of its own
; expect: path x35f100 x40y5f50 y25f100 x35y30 x0
N10 G01 G90 X+40 F100 *
N20 G24 R5 F50 *
N30 Y+30 *
N40 G24 R5 *
N50 X+0 *
N60 M30 *
N99999999 %TEST G71 *
