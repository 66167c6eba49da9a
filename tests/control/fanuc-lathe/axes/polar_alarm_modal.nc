%
O0001
(rule: F 3.6 G12.1: no G00 inside, which is in force from before)
(machine: driven)
(expect: alarm PS0146 K5542 at 9:1)
G98 G97 S1000 M3
G00 X40. C0
G12.1
X20. C5.
M30
%
