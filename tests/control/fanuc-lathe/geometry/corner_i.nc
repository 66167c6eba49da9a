%
O0001
(rule: F 3.8 chamfer by I: the next block goes along X as the sign says)
(expect: to X10 Z0)
(expect: to X10 Z-18)
(expect: to X12 Z-20)
(expect: to X20 Z-20)
S1000M03
G00X20.Z0
G01Z-20.I2.F0.2
X40.
M30
%
