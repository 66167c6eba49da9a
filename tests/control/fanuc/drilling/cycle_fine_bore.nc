%
O0001
(rule: F 5.2 G76: shift by Q at the bottom, rapid out, shift back)
(expect: path Z20 X10 Z2 z-10f100 X10.5 Z2 Z20 X10)
M3S1000
G00X0Y0Z20.
G98G76X10.Z-10.R2.Q0.5P100F100
G80
M30
%
