%TEST G71 *
; rule: HEIDENHAIN G06: an arc that goes on in the direction of the block before it
; expect: to X20 Y0 line
; expect: to X30 Y10 ccw
N10 G01 G90 X+20 Y+0 F200 *
N20 G06 X+30 Y+10 *
N30 M30 *
N99999999 %TEST G71 *
