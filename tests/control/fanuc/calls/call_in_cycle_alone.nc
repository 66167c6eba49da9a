%
O0001
(rule: F 5.1 M98 alone in its block under a cycle: its places are holes)
(expect: path z20f100 Z2 z-5 Z20 X5 Z2 z-5 Z20)
G90G00X0Y0
G01Z20.F100
G98G81X0Y0Z-5.R2.F100
M98P2
G80
M30
O0002
X5.
M99
%
