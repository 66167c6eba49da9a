%
O0001
(rule: F 5.1 a code of group 01 in the block of a cycle: warned, drilled if the cycle stands last)
(expect: path Z20 X10 Z2 z-5f100 Z20)
M3S1000
G00X0Y0Z20.
G00G81X10.Z-5.R2.F100
G80
M30
%
