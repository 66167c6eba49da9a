%
O0001
(rule: F 3.5 PS0021: the cycles work in the plane Z-X)
(expect: alarm PS0021 K5291 at 8:1)
G99 G97 S500 M03
G00 X30. Z2.
G17
G71 P10 Q20 F0.2
N10 G00 X20.
N20 G01 Z-10.
M30
%
