%TEST G71 *
; rule: HEIDENHAIN G29: the place of the tool becomes the pole
; expect: to X5 Y7 rapid
; expect: to X15 Y7 line
; expect: to X5 Y17 ccw
N10 G00 G90 X+5 Y+7 *
N20 G29 *
N30 G11 R+10 H+0 F200 *
N40 G13 H+90 *
N50 M30 *
N99999999 %TEST G71 *
