%
O0001
(rule: F 3.8 chamfer by K behind a move along X)
(expect: to X0 Z0)
(expect: to X8 Z0)
(expect: to X10 Z-2)
(expect: to X10 Z-20)
S1000M03
G00X0Z0
G01X20.K-2.F0.2
Z-20.
M30
%
