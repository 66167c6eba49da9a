%
O0001
(rule: F 5.5, 11 PS0330: H is a distance of C)
(machine: driven)
(expect: alarm PS0330 K5783 at 8:20)
G99 G97 S500 M03
G00 X62. Z2. C0
G94 X40. Z-5. F0.2 H30.
M30
%
