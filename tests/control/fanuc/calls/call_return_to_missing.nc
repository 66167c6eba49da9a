%
O0001
(rule: F 6.8 a block that the caller does not have)
(expect: alarm PS0128 K5431 at 9:1)
(expect: called 6:1)
M98P2
M30
O0002
M99P99
%
