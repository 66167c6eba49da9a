%
O0001
G99 G97 T0101 M03 S500
G00 X30. Z2.
G71 U2. R0.5
G71 P10 Q20 F0.2
N10 G00 X20.
G01 Z-10.
X18. Z-12.
N20 X30. Z-20.
M30
%
(args: run {file} -d fanuc-lathe -m lathe --commands {out})
(expect: 6:1 PS0329 THE FINISHING SHAPE IS NOT A MONOTONOUS CHANGE (SECOND AXES): the shape turns back in X in its block 3)
(exit: 3)
