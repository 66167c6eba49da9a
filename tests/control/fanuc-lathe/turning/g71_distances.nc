%
O0001
(rule: F 2.3 T-A: U and W in a shape are distances from point to point)
(expect: path X30Z2 X26 z-10f0.2 x27z-9.5 Z2 X22 z-10 x23z-9.5 Z2 X20 z-10 x30 Z2)
G99 G97 S500 M03
G00 X30. Z2.
G71 U2. R0.5
G71 P10 Q20 F0.2
N10 G00 U-10.
G01 W-12.
N20 U10.
M30
%
