%
O0001
(rule: F 5.1 G83 without Q, No.5103#3 = 0: in one feed)
(expect: path Z20 X10 Z2 z-5f100 Z20)
M3S1000
G00X0Y0Z20.
G83X10.Z-5.R2.F100
G80
M30
%
