%
O0001
(rule: F 11 PS0325: a cycle inside of a shape)
(expect: alarm PS0325 K5290 at 10:1)
G99 G97 S500 M03
G00 X30. Z2.
G71 U2. R0.5
G71 P10 Q20 F0.2
N10 G00 X20.
G90 X20. Z-10.
N20 G01 X30.
M30
%
