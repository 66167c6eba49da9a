%
O0001
(rule: F 3.4 machine position = EXT + G5x + ...: P0 shifts all of them)
(expect: to X0 Y0 Z5)
(expect: to X10 Y20 Z35)
(expect: #1=5)
(expect: #2=35)
G54
G10L2P0Z5.
G00X0.Y0.Z0.
G55X0.Y0.Z0.
#1=#5203
#2=#5023
M30
%
