%
O0001
(rule: F 11 PS0127)
(expect: alarm PS0127 K5409 at 5:8)
GOTO10 X1.
N10
M30
%
