%
O0001
(rule: F 6.4 /0: PS0112)
(expect: alarm PS0112 K5420 at 5:5)
#1=1/[2-2]
M30
%
