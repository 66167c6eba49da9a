%
O0001
(rule: F 11 PS0065: the first block has no G00 or G01)
(expect: alarm PS0065 K5259 at 9:5)
G99 G97 S500 M03
G00 X30. Z2.
G71 U2. R0.5
G71 P10 Q20 F0.2
N10 X20.
N20 G01 Z-10.
M30
%
