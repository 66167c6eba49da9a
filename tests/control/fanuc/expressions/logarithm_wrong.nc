%
O0001
(rule: F 6.4 LN[0]: PS0119)
(expect: alarm PS0119 K5421 at 5:4)
#1=LN[0]
M30
%
