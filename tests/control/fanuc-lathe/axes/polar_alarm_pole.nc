%
O0001
(rule: F 3.6 G12.1: C would turn at once in the centre)
(machine: driven)
(expect: alarm  K5546 at 12:1)
(expect: to X20)
(expect: to X15 Y0)
G98 G97 S1000 M3
G00 X40. C0
G12.1
G01 X30. F200
X-30.
M30
%
