%
O0001
(rule: F 3.8 the next block is a taper: PS0054)
(expect: alarm PS0054 K5318 at 7:1)
S1000M03
G00X40.Z0
G01Z-20.R-3.F0.2
X0Z-30.
M30
%
