%
O0001
(rule: F 6.7 GOTO looks in its own program only)
(expect: alarm PS0128 K5431 at 10:5)
(expect: called 7:1)
N10
M98P2
M30
O0002
GOTO10
M99
%
