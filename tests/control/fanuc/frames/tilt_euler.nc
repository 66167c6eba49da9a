%
O0001
(rule: F 4.8 G68.2: Euler angles about Z, X', Z''; G69 ends the plane)
(expect: to X-2.3301 Y12 Z7.2321)
(expect: to X10 Y5 Z2)
G68.2X1.Y2.Z3.I90.J30.K0
G00X10.Y5.Z2.
G69
X10.Y5.Z2.
M30
%
