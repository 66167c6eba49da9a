%
O0001
G68 X0. Y0. R30.
G53 G00 Z0.
G69
M30
%
(expect: 4:1 K5234 `G53` stands inside a rotation)
(exit: 3)
