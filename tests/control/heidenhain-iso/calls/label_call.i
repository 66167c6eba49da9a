%TEST G71 *
; rule: HEIDENHAIN L5,0: the blocks from label 5 on up to G98 L0, then on behind the call; behind the program's end
; expect: path x10f500 x15y5 x20 x25y10 x30
N10 T1 G17 S1000 M03 *
N20 G00 G90 Z+0 *
N30 G01 X+10 F500 *
N40 L5,0 *
N50 G90 X+20 *
N60 L5,0 *
N70 G90 X+30 *
N80 M30 *
N90 G98 L5 *
N100 G91 X+5 Y+5 *
N110 G98 L0 *
N99999999 %TEST G71 *
