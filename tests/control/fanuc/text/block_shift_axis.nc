%
O0001
(rule: F 3.4 G52 shifts axes of the machine alone)
(expect: alarm PS0009 K5230 at 5:4)
G90G52X10.A5.
M30
%
