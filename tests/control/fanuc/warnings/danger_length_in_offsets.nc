%
O0001
(rule: technologist, wrong motion: a program that calls no length at all has them in its work offsets)
T1M6S1000M3
G54G0X0Y0Z50.
G1Z2.F100.
G0Z50.
T2M6
G55G0Z50.
G1Z2.
G0Z50.
M30
%
