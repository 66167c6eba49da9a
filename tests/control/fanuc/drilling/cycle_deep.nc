%
O0001
(rule: F 5.2 the worked expansion of G83, d83 = 1)
(expect: path Z20 X10 Z2 z-2f100 Z2 Z-1 z-6 Z2 Z-5 z-10 Z20)
M3S1000
G00X0Y0Z20.
G90G98G83X10.Y0Z-10.R2.Q4.F100
G80
M30
%
