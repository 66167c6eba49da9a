%
O0001
(rule: F 3.8 the next block goes the other way: PS0051)
(expect: alarm PS0051 K5906 at 7:1)
S1000M03
G00X40.Z0
G01Z-20.R3.F0.2
X0
M30
%
