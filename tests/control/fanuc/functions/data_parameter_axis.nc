%
O0001
(rule: F 3.4 G10 L52: P is the number of an axis)
(expect: alarm PS1300 K5576 at 6:6)
G10L52
N1006P9R0
G11
M30
%
