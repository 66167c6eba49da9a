%
O00001
(rule: Haas G68: about X and Y by R degrees, G69 ends it)
(expect: to X0 Y10)
(expect: to X10 Y0)
G68 X0. Y0. R90.
G00 X10. Y0.
G69
X10. Y0.
M30
%
