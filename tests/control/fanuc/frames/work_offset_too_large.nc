%
O0001
(rule: F 2.2 G54.1 P301: PS0030)
(expect: alarm PS0030 K5232 at 5:6)
G54.1P301
M30
%
