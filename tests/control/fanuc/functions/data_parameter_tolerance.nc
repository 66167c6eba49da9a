%
O0001
(rule: F 3.4 and 3.5 G10 L52 writes No.3410, the tolerance of arcs, in thousandths; 60 are 0.06 mm)
(expect: path X10 ccw:x0y10.05f100)
G00X10.Y0
G10L52
N3410R60
G11
S500M03
G03X0Y10.05I-10.J0F100.
M30
%
