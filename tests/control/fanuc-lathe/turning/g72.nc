%
O0001
(rule: F 5.6 G72: as G71 with the axes exchanged: cuts along X, one behind the other along Z)
(expect: path X60Z2 X60.4Z2.1 Z0.1 x20.4f0.25 x21.4z0.6 X60.4 Z-1.9 x22.4 x23.4z-1.4 X60.4 Z-3.9 x26.4 x27.4z-3.4 X60.4)
(expect: path Z-4.9 x28.4 x20.4z-0.9 z2.1 X60Z2)
G99 G97 S500 M03
G00 X60. Z2.
G72 W2. R0.5
G72 P10 Q20 U0.4 W0.1 F0.25
N10 G00 Z-5.
G01 X28.
X20. Z-1.
N20 Z2.
M30
%
