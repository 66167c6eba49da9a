%
O0001
(rule: F 5.1 G91: R from the initial level, Z from R, K holes in a row)
(expect: path Z20 X10 Z2 z-10f100 Z2 X20 z-10 Z2 X30 z-10 Z2)
M3S1000
G00X0Y0Z20.
G91G99G81X10.Z-12.R-18.K3F100
G80
M30
%
