%
O0001
(rule: F 5.5, 11 PS0330: an axis beside X and Z in a single cycle)
(machine: driven)
(expect: alarm PS0330 K5783 at 8:20)
G99 G97 S500 M03
G00 X62. Z2. C0
G90 X60. Z-5. F0.2 C30.
M30
%
