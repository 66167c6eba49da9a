%
O0001
(rule: F 3.2 G05.1 may name the axes that it smooths: no axis moves, and the path is the same)
(expect: to X5 Y5 Z5)
(expect: to X9 Y5 Z5)
(expect: to X10 Y5 Z5)
G00X5.Y5.Z5.
G05.1Q1X0Y0Z0
G05.1Q1R5X0Y0
G00X9.
G05.1Q2X0Y0
G05.1Q3X0Y0Z0C0
G05.1Q0
X10.
M30
%
