%
O0001
(rule: F 11 PS0031 G54.1 has P1 to P300)
(expect: alarm PS0031 K5281 at 5:7)
G10L20P301X0.
M30
%
