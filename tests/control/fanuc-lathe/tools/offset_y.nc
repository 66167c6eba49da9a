%
O0001
(rule: F 6.5 offsets along Y: not executed)
(expect: alarm  K5018 at 5:4)
#1=#14001
M30
%
