%
O0001
(rule: F 3.7 a new G68 replaces)
(expect: to X0 Y10)
G68X0Y0R30.
G68X0Y0R90.
X10.Y0
M30
%
