%
O0001
(rule: F 2.3 a code does not begin with its point)
(expect: alarm PS0007 K5005 at 5:1)
G.0X5.
M30
%
