%
O0001
(rule: F 3.8 two lines, chamfer where they meet)
(expect: to X10 Z0)
(expect: to X10 Z-8)
(expect: to X11.4142 Z-11.4142)
(expect: to X20 Z-20)
S1000M03
G00X20.Z0
G01,A180.,C2.F0.2
X40.Z-20.,A135.
M30
%
