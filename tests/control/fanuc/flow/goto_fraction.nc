%
O0001
(rule: F 6.7 no whole number)
(expect: alarm PS1128 K5430 at 5:5)
GOTO10.5
N10
M30
%
