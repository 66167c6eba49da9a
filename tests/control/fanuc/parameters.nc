%
O0001
(rule: F 6.4 PRM reads parameters: not known here)
(expect: alarm PS0199 K5407 at 5:4)
#1=PRM[3410]
M30
%
