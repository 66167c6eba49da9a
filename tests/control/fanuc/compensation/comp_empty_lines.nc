%
O0001
(rule: case 1: a block with a number or a comment alone, or none of both, is no block without motion)
(expect: path X-20Y-20 x-2.071y5f100 x35 y35 x0 x-20y40)
G10 L12 P1 R5.
M03 S1000
G17 G00 X-20. Y-20.
G41 D1 G01 X0 Y0 F100
N1 (the first)
N2
N3;

N4 (the fourth)
N5;
X40.
N6
N7
N8
N9
Y40.
X0
G40 X-20.
M30
%
