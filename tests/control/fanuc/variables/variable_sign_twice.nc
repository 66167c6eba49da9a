%
O0001
(rule: F 6.2 ##1 is no variable: PS0114)
(expect: alarm PS0114 K5401 at 6:4)
#1=2
#2=##1
M30
%
