%
O0001
(rule: F 11 PS0056: the end and the angle)
(expect: alarm PS0056 K5324 at 5:11)
G01X10.Y5.,A45.F100
M30
%
