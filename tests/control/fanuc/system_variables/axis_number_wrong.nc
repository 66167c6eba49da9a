%
O0001
(rule: F 6.6 AX[12] on a machine without such an axis)
(expect: alarm PS0331 K5428 at 5:7)
G00AX[12]=10.
M30
%
