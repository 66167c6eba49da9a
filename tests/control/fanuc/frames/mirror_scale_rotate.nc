%
O0001
(rule: F 12 G51.1, G51, G68: mirrored, scaled, turned the other way)
(expect: to X0 Y20)
G51.1X0
G51X0Y0P2000
G68X0Y0R90.
G90X10.Y0
M30
%
