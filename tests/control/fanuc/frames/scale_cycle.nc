%
O0001
(rule: F 3.7 a scaling does not act on strokes and clearances of a cycle)
(expect: path Z20 X20 Z4 z0f100 Z4 Z1 z-4 Z4 Z-3 z-8 Z4 Z-7 z-12 Z4 Z-11 z-16 Z4 Z-15 z-20 Z20 X2)
G00X0Y0Z20.S1000M3
G51X0Y0Z0P2000
G83X10.Y0Z-10.R2.Q4.F100
G80X1.
G50
M30
%
