%
O0001
(rule: F 5.1 the initial level is where the mode began, whatever Z comes later)
(expect: path Z20 X10 Z2 z-5f100 Z2 X20 z-5 Z20)
M3S1000
G00X0Y0Z20.
G99G81X10.Z-5.R2.F100
G98X20.
G80
M30
%
