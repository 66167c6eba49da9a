%TEST G71 *
; rule: HEIDENHAIN G25: a rounding between the blocks before and behind it, in polar coordinates too
; expect: path x35f100 ccw:x40y5 y25 ccw:x35y30 x0
N10 G01 G90 X+40 F100 *
N20 G25 R5 *
N30 Y+30 *
N40 G25 R5 *
N50 I+40 J+30 *
N60 G11 R+40 H+180 *
N70 M30 *
N99999999 %TEST G71 *
