%
O0001
(rule: F 2.3, 5.6 T-B: G71 as in system A, U and W are no distances elsewhere)
(expect: path X30Z2 X30.4Z2.1 X26.4 z-9.9f0.2 x27.4z-9.4 Z2.1 X22.4 z-9.9 x23.4z-9.4 Z2.1 X20.4 z-9.9 x30.4 X30Z2)
(expect: path X20 z-10 x30 Z2)
G90 G95 G97 S500 M03
G00 X30. Z2.
G71 U2. R0.5
G71 P10 Q20 U0.4 W0.1 F0.2
N10 G00 X20.
G01 Z-10.
N20 X30.
G70 P10 Q20
M30
%
