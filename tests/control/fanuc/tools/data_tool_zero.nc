%
O0001
(rule: F 11 PS0031 offsets count from 1)
(expect: alarm PS0031 K5281 at 5:7)
G10L10P0R1.
M30
%
