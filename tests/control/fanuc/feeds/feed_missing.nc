%
O0001
(rule: F 2.5 no F at all: PS0011)
(expect: alarm PS0011 K5210 at 5:1)
G01X10.
M30
%
