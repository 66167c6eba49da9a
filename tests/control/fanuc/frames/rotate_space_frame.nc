%
O0001
(rule: F 3.7 G68 with I J K: in space, about an axis through a point that becomes the origin)
(expect: to X100 Y0 Z0)
(expect: to X100 Y10 Z0)
(expect: to X108.660254 Y10 Z-5)
(expect: to X113.660254 Y10 Z3.660254)
(expect: to X0 Y0 Z0)
(expect: #1=10)
(expect: #2=68)
G90G54G00X100.Y0Z0
G68X100.Y0Z0I0J1.K0R30.
G00Y10.
X10.
Z10.
#1=#5003
#2=#4016
G69
G90X0Y0Z0
M30
%
