%
O0001
(rule: F 12 SQRT[-1]: PS0119)
(expect: alarm PS0119 K5421 at 5:4)
#1=SQRT[-1]
M30
%
