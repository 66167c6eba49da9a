%
O0001
(rule: F 3.8 X and an angle; from +Z, counter-clockwise)
(expect: to X10 Z0)
(expect: to X20 Z-10)
S1000M03
G00X20.Z0
G01X40.,A135.F0.2
M30
%
