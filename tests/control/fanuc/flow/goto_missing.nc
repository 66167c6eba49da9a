%
O0001
(rule: F 12 GOTO55 without N55: PS0128)
(expect: alarm PS0128 K5431 at 5:5)
GOTO55
M30
%
