%
O0001
(rule: F 5.1 PS5329: M98 beside other words under a cycle)
(expect: alarm PS5329 K5476 at 9:4)
(expect: path z20f100 Z2 z-5 Z20)
G90G00X0Y0
G01Z20.F100
G98G81Z-5.R2.F100
X5.M98P2
M30
O0002
X1.
M99
%
