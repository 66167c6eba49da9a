%
O0001
(rule: F 6.4 too many digits: PS0003)
(expect: alarm PS0003 K5004 at 6:4)
#1=1234567
G00X#1
M30
%
