%
O0001
(rule: F 6.5 a group that does not exist)
(expect: alarm PS0115 K5410 at 5:4)
#1=#4031
M30
%
