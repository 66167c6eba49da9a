%
O0001
(rule: F 3.8 corner by R)
(expect: to X20 Z0)
(expect: to X20 Z-17 line)
(expect: to X17 Z-20 ccw I17 K-17)
(expect: to X0 Z-20)
S1000M03
G00X40.Z0
G01Z-20.R-3.F0.2
X0
M30
%
