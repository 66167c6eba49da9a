%
O0001
G68 X0. Y0. R30.
G51 X0. Y0. Z0. P2000
G69
M30
%
(expect: 4:1 K5234 `G51` stands inside a rotation)
(exit: 3)
