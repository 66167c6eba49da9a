%
O0001
(rule: F 3.6 G07.1: no G00 inside)
(machine: driven)
(expect: alarm PS0176 K5543 at 10:1)
G98 G97 S1000 M3
G00 X40. C0
G07.1 C20.
G01 C10. F100
G00 C90.
M30
%
