%
O0001
G99 G97 T0101 M03 S500
G00 X30. Z2.
G71 U2. R0.5
G71 P10 Q25 U0.4 W0.1 F0.2
N10 G00 X20.
N20 G01 Z-10.
M30
%
(args: run {file} -d fanuc-lathe -m lathe --commands {out})
(expect: 6:1 PS0063 THE BLOCK OF A SPECIFIED SEQUENCE NUMBER IS NOT FOUND: there is no block `N25` for the shape of the cycle)
(exit: 3)
