%
O0001
(rule: F 6.8 a program that is not there)
(expect: alarm PS0076 K5460 at 5:4)
M98P77
M30
%
