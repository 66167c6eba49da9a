%
O0001
(rule: F 11 PS1133)
(expect: alarm PS1133 K5408 at 5:4)
#1 5
M30
%
