%
O0001
(rule: case 1: nor one between the sides of a rounding)
(expect: path x45f100 ccw:x50y5 y50)
M03 S1000
G01 X50. ,R5. F100
N4 (the first)
N5
N6;

N7
Y50.
M30
%
