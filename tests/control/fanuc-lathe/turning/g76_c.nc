%
O0001
(rule: F 5.6, 11 PS0066: an axis beside the words of a multiple cycle)
(machine: driven)
(expect: alarm PS0066 K5784 at 9:15)
G99 G97 S500 M03
G00 X62. Z2. C0
G76 P010060 Q50 R0.05
G76 X58. Z-5. C30. P900 Q300 F2.
M30
%
