%
O0001
(rule: F 3.7 a factor of 0: PS0142)
(expect: alarm PS0142 K5236 at 5:1)
G51X0Y0P0
M30
%
