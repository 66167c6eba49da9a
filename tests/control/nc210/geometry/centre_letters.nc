%
;rule: NC-210 7: I is the first axis of the plane and J the second, in every plane: Z and X under G18
;expect: to X0 Y0 Z0 rapid
;expect: to X5 Z-5 cw I5 K0 F200
G71 G90 G94 S1000 M3
G18
G0 X0 Z0
G2 X5. Z-5. I0 J5. F200.
M30
