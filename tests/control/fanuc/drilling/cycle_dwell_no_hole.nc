%
O0001
(rule: F 5.1 G04 X in the mode drills no hole)
(expect: path Z20 X10 Z2 z-5f100 Z2)
M3S1000
G00X0Y0Z20.
G99G81X10.Z-5.R2.F100
G04X1.
G80
M30
%
