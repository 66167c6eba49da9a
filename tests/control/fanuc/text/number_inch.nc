%
O0001
(rule: F 1.6 IS-B in inches: 0.0001)
(expect: to X25.4)
(expect: to X31.3563)
G20
X10000
X1.23456
M30
%
