%
O0001
(rule: F 11 PS0061: neither P nor Q: no axis moves by U and W)
(expect: alarm PS0061 K5257 at 8:1)
G99 G97 S500 M03
G00 X30. Z2.
G71 U2. R0.5
G71 U0.4 W0.1 F0.2
M30
%
