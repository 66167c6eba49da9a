%
O0001
(rule: F 12 G68 X10 Y0 R90, then X20 Y0)
(expect: to X10 Y10)
(expect: to X5 Y5)
G68X10.Y0R90.
X20.Y0
G69
X5.Y5.
M30
%
