%
;rule: NC-210 7: under G90 I and J are the coordinates of the centre
;expect: to X0 Y0 Z0 rapid
;expect: to X10 Y10 cw I10 J0 F200
G17 G71 G90 G94 S1000 M3
G0 X0 Y0
G2 X10. Y10. I10. J0 F200.
M30
