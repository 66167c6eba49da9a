%
O0001
(rule: F 5.6 G71: dW below 0, cuts run towards Z plus)
(expect: path X40Z-30 X40.4Z-30.1 X36.4 z-10.1f0.2 x37.4z-10.6 Z-30.1 X32.4 z-10.1 x33.4z-10.6 Z-30.1)
(expect: path X30.4 z-10.1 x40.4 X40Z-30)
G99 G97 S500 M03
G00 X40. Z-30.
G71 U2. R0.5
G71 P10 Q20 U0.4 W-0.1 F0.2
N10 G00 X30.
G01 Z-10.
N20 X40.
M30
%
