%
O0001
(rule: F 5.6 G72: from a bore outwards)
(expect: path X20Z2 Z0 x40f0.2 x39z0.5 X20 Z-2 x40 x39z-1.5 X20 Z-3 x40 z2 X20)
G99 G97 S500 M03
G00 X20. Z2.
G72 W2. R0.5
G72 P10 Q20 F0.2
N10 G00 Z-3.
G01 X40.
N20 Z2.
M30
%
