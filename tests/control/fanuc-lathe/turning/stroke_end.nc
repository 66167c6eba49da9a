%
O0001
(rule: F 11 PS0319: G74 without the end of its strokes)
(expect: alarm PS0319 K5253 at 9:1)
G99G97S500M03
T0101
G00X50.Z2.
G74R1.
G74X30.P2000Q2000F0.1
M30
%
