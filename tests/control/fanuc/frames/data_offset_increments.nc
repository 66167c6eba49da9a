%
O0001
(rule: F 1.6 a value of G10 without a point counts in increments)
(expect: to X0.1)
G10L2P1X100
G54G00X0.
M30
%
