%
O0001
(rule: F 3.6 G13.1: not while cutter compensation acts)
(machine: driven)
(expect: alarm PS0145 K5550 at 13:1)
G10 P10002 R5. Q0
G98 G97 S1000 M3
T0202
G00 X80. C0
G12.1
G42 G01 X40. F200
C20.
G13.1
M30
%
