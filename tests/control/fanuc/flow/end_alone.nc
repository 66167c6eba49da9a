%
O0001
(rule: F 6.7 PS1124)
(expect: alarm PS1124 K5435 at 6:1)
#1=1
END1
M30
%
