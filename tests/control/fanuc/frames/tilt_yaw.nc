%
O0001
(rule: F 4.8 G68.2 P1 Q321: about the fixed axes Z, Y, X)
(expect: to X5.7194 Y7.7279 Z6.0471)
G68.2P1Q321X0Y0Z0I20.J-10.K30.
G00X10.Y5.Z2.
M30
%
