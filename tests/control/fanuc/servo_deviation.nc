%
O0001
(rule: F 6.5 #5101: what the drives do nobody knows here)
(expect: alarm  K5018 at 5:4)
#1=#5101
M30
%
