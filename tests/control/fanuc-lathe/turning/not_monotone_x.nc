%
O0001
(rule: F 11 PS0329: the shape of type I turns back along the second axis)
(expect: alarm PS0329 K5253 at 8:1)
G99 G97 S500 M03
G00 X30. Z2.
G71 U2. R0.5
G71 P10 Q20 F0.2
N10 G00 X20.
G01 Z-10.
X18. Z-12.
N20 X30. Z-20.
M30
%
