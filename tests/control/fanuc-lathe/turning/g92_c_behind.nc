%
O0001
(rule: F 5.5, 11 PS0330: C in a block that repeats the cycle)
(machine: driven)
(expect: path X62Z2 X60 t2:z-4 t2.8284:x62z-5 Z2)
(expect: alarm PS0330 K5783 at 10:1)
G99 G97 S500 M03
G00 X62. Z2. C0
G92 X60. Z-5. F2.
C30.
M30
%
