%
O0001
(rule: F 6.4, 11 a closing bracket alone: PS1131)
(expect: alarm PS1131 K5015 at 5:7)
#1=1+2]
M30
%
