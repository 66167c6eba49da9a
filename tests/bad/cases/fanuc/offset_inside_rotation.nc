%
O0001
G54
G68 X0. Y0. R30.
G00 X5.
G55 X10.
G69
M30
%
(expect: 6:1 K5234 `G55` stands inside a rotation)
(exit: 3)
