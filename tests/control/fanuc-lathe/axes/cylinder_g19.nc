%
O0001
(rule: F 3.6 G07.1 with G19: C is the first axis of the plane, so that the same arc is G02)
(machine: driven)
(expect: to X20 Z0 C0 rapid)
(expect: to X20 Y31.415927 Z-20 C90)
(expect: to Y41.415616 Z-30 C118.647 cw J31.415616 K-30)
G98 G97 S1000 M3
G00 X40. Z0 C0
G19
G07.1 C20.
G01 Z-20. C90. F100
G02 Z-30. C118.647 R10.
G07.1 C0
M30
%
