%
O0001
(rule: F 11 PS0318: the relief of G74 is below 0)
(expect: alarm PS0318 K5253 at 8:1)
G99 G97 S500 M03
G00 X30. Z2.
G74 R0.5
G74 X20. Z-20. P2000 Q5000 R-0.5 F0.1
M30
%
