%
O0001
(rule: F 6.2 PS0111)
(expect: alarm PS0111 K5422 at 5:4)
#1=EXP[1000]
M30
%
