%
O0001
(rule: F 5.1 levels of holes: K0 stores, Z or R alone drills again with the new level, G80 and G00 leave)
(expect: path Z10 X10 Z1 z-5f100 Z10 X20Y5 Z1 z-5 Z10 X50)
(expect: path X60 Z2 z-3 Z2 z-4 Z2 Z1 z-4 Z1 X70 X75 Z-7 z-12 Z-7 X80 z-12 Z-7 X85 z-12 Z-7)
G90G54G00X0Y0S500M03
Z10.
G98G81Z-5.R1.F100K0
X10.
X20.Y5.M08
G00X50.
G81G99X60.R2.Z-3.
Z-4.
R1.
G80X70.
G80
G91G81X5.Z-5.R-8.K3
G80G90
M30
%
