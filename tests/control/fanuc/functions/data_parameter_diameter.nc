%
O0001
(rule: F 3.1 and 3.4 G10 L52 writes No.1006 of axis 1: with bit 3 X is a diameter, without it a radius)
(expect: path X10 X30 X20)
G00X10.
G10L52
N1006P1R00001000
G11
X60.
G10L52
N1006P1R00000000
G11
X20.
M30
%
