%
O0001
(rule: F 3.4 G54.1 P0: PS0030)
(expect: alarm PS0030 K5232 at 5:6)
G54.1P0
M30
%
