%
O0001
G99 G97 T0101 M03 S500
G00 X30. Z2.
G71 U2. R0.5
G71 P10 Q20 U0.4 W0.1 F0.2
N10 G00 X20.
G04 P500
N20 G01 Z-10.
M30
%
(args: run {file} -d fanuc-lathe -m lathe --commands {out})
(expect: 8:1 PS0325 UNAVAILABLE COMMAND IS IN SHAPE PROGRAM: `G04` cannot stand in the shape of a cycle)
(exit: 3)
