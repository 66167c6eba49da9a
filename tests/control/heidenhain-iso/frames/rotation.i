%TEST G71 *
; rule: HEIDENHAIN G73: rotation in the plane, a new one replaces it, 0 ends it
; expect: to X0 Y10
; expect: to X-10 Y0
; expect: to X10 Y0
N10 G73 G90 H+90 *
N20 G00 X+10 Y+0 *
N30 G73 G90 H+180 *
N40 X+10 Y+0 *
N50 G73 G90 H0 *
N60 X+10 Y+0 *
N70 M30 *
N99999999 %TEST G71 *
