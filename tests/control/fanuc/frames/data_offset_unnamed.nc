%
O0001
(rule: F 3.4 axes that G10 L2 does not name keep their shift)
(expect: to X50 Y20 Z30)
G10L2P2X50.
G55G00X0.Y0.Z0.
M30
%
