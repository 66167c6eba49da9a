%
O0001
(rule: F 3.5 R too small: within the tolerance a half circle)
(expect: to X1)
(expect: to X21 Y0 ccw I11 J0)
G17G21G90
S1000M3
G1X1.F100
G3X21.Y0R9.999
M30
%
