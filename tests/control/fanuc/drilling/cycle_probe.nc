%
O0001
(rule: F 5.1 ... nor for a probing move)
(expect: path X5 Z2 z-5f100 Z2 Z0)
(expect: alarm  K5340 at 8:1)
S1000M3
G81X5.Z-5.R2.F100
G31X50.F100
M30
%
