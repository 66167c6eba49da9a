%
O0001
(rule: F 1.6 S has five digits: PS0003)
(expect: alarm PS0003 K5004 at 5:1)
S123456
M30
%
