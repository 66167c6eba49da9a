%
O0001
(rule: F 11 PS0320: strokes of nothing)
(expect: alarm PS0320 K5253 at 8:1)
G99 G97 S500 M03
G00 X30. Z2.
G74 R0.5
G74 Z-20. Q0 F0.1
M30
%
