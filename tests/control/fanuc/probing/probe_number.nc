%
O0001
(rule: F 11 PS0370: G31 P1 to P4)
(expect: alarm PS0370 K5012 at 5:4)
G31P9X1.F100
M30
%
