%
O0001
(rule: F 5.1 G80 with words moves; a code of group 01 ends the mode; data are forgotten)
(expect: path Z20 X10 Z2 z-5f100 Z2 X20 X30 Z1 z-3 Z1 X40 X50)
M3S1000
G00X0Y0Z20.
G99G81X10.Z-5.R2.F100
G80X20.
G81X30.Z-3.R1.
G00X40.
X50.
M30
%
