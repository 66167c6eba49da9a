%
O0001
(rule: F 2.5 F0: PS0011)
(expect: alarm PS0011 K5211 at 5:8)
G01X10.F0
M30
%
