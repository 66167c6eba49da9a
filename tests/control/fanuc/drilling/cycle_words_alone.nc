%
O0001
(rule: F 5.1 Q in a block that drills nothing is not stored)
(expect: path Z20 X10 Z2 z-1f100 Z2 Z0 z-4 Z2 X20 z-1 Z2 Z0 z-4 Z2)
M3S500
G00Z20.
G99G83X10.Z-4.R2.Q3.F100
Q8.
X20.
G80
M30
%
