%
O0001
(rule: F 6.4 MOD 0: PS0112)
(expect: alarm PS0112 K5420 at 5:5)
#1=7MOD0.4
M30
%
