%
O0001
(rule: F 1.6 ... and M1.5)
(expect: alarm PS0007 K5005 at 5:1)
M1.5
M30
%
