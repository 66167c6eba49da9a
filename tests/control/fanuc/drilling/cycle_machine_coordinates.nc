%
O0001
(rule: F 5.1 no hole is drilled for machine coordinates among those of a cycle)
(expect: path X5 Z2 z-5f100 Z2 Z0)
(expect: alarm  K5340 at 8:1)
S1000M3
G81X5.Z-5.R2.F100
G53X50.
M30
%
