%
O0001
(rule: F 12 G51 P2000, G68: the point is scaled, then turned about the scaled centre)
(expect: to X20 Y40)
G51X0Y0P2000
G68X10.Y0R90.
G90X30.Y0
M30
%
