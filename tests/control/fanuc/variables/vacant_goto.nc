%
O0001
(rule: F 6.3 GOTO#1: PS1128)
(expect: alarm PS1128 K5430 at 5:5)
GOTO#1
M30
%
