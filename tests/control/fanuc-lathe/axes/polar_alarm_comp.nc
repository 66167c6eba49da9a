%
O0001
(rule: F 3.6 G12.1: not while cutter compensation acts)
(machine: driven)
(expect: alarm PS0145 K5550 at 10:1)
G98 G97 S1000 M3
T0202
G00 X40. Z0 C0
G42 G01 X38. F200
G12.1
M30
%
