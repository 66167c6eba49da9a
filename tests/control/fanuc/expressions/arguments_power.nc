%
O0001
(rule: F 11 PS1120: POW of one argument)
(expect: alarm PS1120 K5406 at 5:4)
#1=POW[2]
M30
%
