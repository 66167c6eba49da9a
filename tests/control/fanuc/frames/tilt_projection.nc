%
O0001
(rule: F 4.8 G68.2 P4: X turned about Y by I, Y about X by J, then K about their normal)
(expect: to X9.6718 Y5.5663 Z2.1149)
G68.2P4X0Y0Z0I20.J30.K15.
G00X10.Y5.Z2.
M30
%
