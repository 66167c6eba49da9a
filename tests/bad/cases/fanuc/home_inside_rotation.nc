%
O0001
G68 X0. Y0. R30.
G28 Z50.
G69
M30
%
(expect: 4:1 K5234 `G28` stands inside a rotation)
(exit: 3)
