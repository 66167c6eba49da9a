%
O0001
(rule: F 2.3 G50 X Z sets the work system, G50.3 takes it back)
(expect: to X20 Z0)
(expect: to X20 Z-10)
(expect: to X30 Z0)
G00X40.Z0
G50X60.Z100.
X60.Z90.
G50.3X0Z0
X60.Z0
M30
%
