%
O0001
(rule: F 5.1 the drilling axis is the normal of the plane: Z is a place in G18, in the first block too)
(expect: path Y20 X10Z7 Y2 y-6f100 Y20 Z9 Y2 y-6 Y20)
G18G00X0Z0Y20.S1000M3
G81X10.Z7.Y-6.R2.F100
Z9.
G80
M30
%
