%
O0001
(rule: F 6.4 PS0119)
(expect: alarm PS0119 K5421 at 5:4)
#1=ASIN[1.5]
M30
%
