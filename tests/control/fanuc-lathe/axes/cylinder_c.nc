%
O0001
(rule: F 3.6 G07.1, G107 on a lathe: C is an angle, on arcs and for the feed a length around)
(machine: driven)
(expect: to X20 Z0 C0 rapid)
(expect: to X19 Y0 Z0 C0 F100)
(expect: to X19 Y31.415927 Z-20 C90)
(expect: to Y41.415616 Z-30 C118.647 cw J31.415616 K-30)
(expect: to Y0 Z-30 C0)
(expect: to X30 C0 rapid)
(expect: to X30 C90 rapid)
G98 G97 S1000 M3
G00 X40. Z0 C0
G18
G107C20.
G01 X38. F100
Z-20. C90.
G03 Z-30. C118.647 R10.
G01 C0
G107C0
G00 X60.
C90.
M30
%
