%
;rule: NC-210 12: (CLS,FILE) runs another program, which shares all parameters, and goes on
;expect: E31=8
;expect: path X4 Y9
E30=4
(CLS,HOLE)
G0 Y9.
M30
