%TEST G71 *
; rule: HEIDENHAIN G10, G11: the end by radius and angle from the pole I, J; what is not said is that of the tool's place
; expect: to X0 Y0 rapid
; expect: to X10 Y40 rapid
; expect: to X30 Y20 line
; expect: to X15 Y20 line
; expect: to X5 Y20 line
; expect: to X10 Y10 line
; expect: to X20 Y20 line
; expect: to X0 Y0 line
; expect: to X10 Y30 Z5 line
N10 G00 G90 X+0 Y+0 *
N20 I+10 J+20 *
N30 G10 R+20 H+90 *
N40 G11 H+0 F200 *
N50 R+5 *
N60 H+180 *
N70 R+10 H-90 *
N80 G91 H+90 *
N90 G90 G01 X+0 Y+0 *
N100 G11 R+10 H+450 Z+5 *
N110 M30 *
N99999999 %TEST G71 *
