%
O0001
(rule: F 3.6 G12.1: no other coordinate system inside)
(machine: driven)
(expect: alarm PS0146 K5542 at 10:1)
G98 G97 S1000 M3
G00 X40. C0
G12.1
G01 X20. F200
G55
M30
%
