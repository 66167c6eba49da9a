%
O0001
(rule: F 1.6 PS0007: no decimal point in N)
(expect: alarm PS0007 K5005 at 5:1)
N10.G00
M30
%
