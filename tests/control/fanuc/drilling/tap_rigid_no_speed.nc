%
O0001
(rule: F 5.3 PS0200: M29 without S)
(expect: alarm PS0200 K5243 at 7:1)
G00Z20.
M29
G84X10.Z-10.R2.F500.
M30
%
