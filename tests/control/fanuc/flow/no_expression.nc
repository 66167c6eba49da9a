%
O0001
(rule: F 11 PS0114)
(expect: alarm PS0114 K5401 at 5:4)
#1=*2
M30
%
