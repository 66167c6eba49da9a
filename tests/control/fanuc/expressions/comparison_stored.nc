%
O0001
(rule: F 6.4 a comparison cannot be stored: PS0114)
(expect: alarm PS0114 K5401 at 5:4)
#1=[#2GT3]
M30
%
