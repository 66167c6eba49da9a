%
O0001
(rule: F 1.6 degrees in IS-B: 0.001)
(expect: alarm PS0009 K5230 at 5:1)
A1000
A1.5
M30
%
