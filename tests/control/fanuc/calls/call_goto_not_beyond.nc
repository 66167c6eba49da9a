%
O0001
(rule: F 6.7 GOTO looks in its own program only)
(expect: alarm PS0128 K5431 at 5:5)
GOTO20
M30
O0002
N20
M99
%
