%
O0001
(rule: F 6.4 N#1 is illegal)
(expect: alarm PS0005 K5003 at 5:1)
N#1 G00X1.
M30
%
