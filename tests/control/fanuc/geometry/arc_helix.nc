%
O0001
(rule: F 3.5 helix: Z grows with the angle)
(expect: to X20 Y0 Z-5 cw I10 J0)
G02X20.Y0Z-5.I10.F100
M30
%
