%
O0001
(rule: F 2.3 a code has no sign)
(expect: alarm PS0006 K5006 at 5:1)
G-0X5.
M30
%
