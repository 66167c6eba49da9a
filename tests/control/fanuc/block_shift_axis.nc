%
O0001
(rule: F 3.4 an axis that G52 does not take stands in another block)
(expect: alarm PS0010 K5013 at 5:4)
G90G52X10.A5.
M30
%
