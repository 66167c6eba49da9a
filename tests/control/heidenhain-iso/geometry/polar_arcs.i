%TEST G71 *
; rule: HEIDENHAIN G12, G13: arcs about the pole, by the angle of their end; G16: goes on in the direction so far; full turns under G91
; expect: to X20 Y0 rapid
; expect: to X0 Y20 ccw
; expect: to X20 Y0 cw
; expect: to X0 Y-20 cw
; expect: to X-20 Y0 cw
; expect: to X-20 Y0 Z-10 ccw
N10 G00 G90 X+20 Y+0 Z+0 *
N20 I+0 J+0 *
N30 G13 H+90 F200 *
N40 G12 H+0 *
N50 H-90 *
N60 G16 R+20 H+180 *
N70 G13 G91 H+720 Z-10 *
N80 M30 *
N99999999 %TEST G71 *
