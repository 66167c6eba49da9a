%
O0001
(rule: F 6.4 PRM reads parameters: not known here, and told by what it is)
(expect: alarm  K5018 at 5:4)
#1=PRM[3410]
M30
%
