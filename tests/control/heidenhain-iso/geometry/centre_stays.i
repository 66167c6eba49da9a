%TEST G71 *
; rule: HEIDENHAIN: the centre stays for the arcs behind it
; expect: to X0 Y0
; expect: to X10 Y10
; expect: to X20 Y0
N10 G00 X+0 Y+0 *
N20 G02 X+10 Y+10 I+10 J+0 F200 *
N30 X+20 Y+0 *
N40 M30 *
N99999999 %TEST G71 *
