%
O0001
(rule: F 5.2 the worked expansion of G73, d73 = 0.5)
(expect: path Z20 X10 Z2 z-2f100 Z-1.5 z-6 Z-5.5 z-10 Z20)
M3S1000
G00X0Y0Z20.
G90G98G73X10.Y0Z-10.R2.Q4.F100
G80
M30
%
