%
O0001
(rule: F 4.8 G68.2 P2: origin, a point on X, one on the side of +Y; Q0 shifts in the plane and turns about its Z)
(expect: to X1 Y-1 Z13)
G68.2P2Q0X5.Y0Z1.R90.
G68.2P2Q1X1.Y2.Z3.
G68.2P2Q2X9.Y2.Z3.
G68.2P2Q3X1.Y2.Z8.
G00X10.Y5.Z2.
M30
%
