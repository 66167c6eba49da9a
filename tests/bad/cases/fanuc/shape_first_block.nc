%
O0001
G99 G97 T0101 M03 S500
G00 X30. Z2.
G71 U2. R0.5
G71 P10 Q20 U0.4 W0.1 F0.2
N10 X20.
N20 G01 Z-10.
M30
%
(args: run {file} -d fanuc-lathe -m lathe --commands {out})
(expect: 7:5 PS0065 G00/G01 IS NOT IN THE FIRST BLOCK OF SHAPE PROGRAM: the first block of the shape has no G00 or G01)
(exit: 3)
