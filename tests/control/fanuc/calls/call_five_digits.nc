%
O0001
(rule: F 6.8 with L the number is all program)
(expect: alarm PS0076 K5460 at 5:4)
M98P30012L2
M30
%
