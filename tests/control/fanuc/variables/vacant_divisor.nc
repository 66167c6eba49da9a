%
O0001
(rule: F 6.3 5/#1: PS0112)
(expect: alarm PS0112 K5420 at 5:5)
#2=5/#1
M30
%
