%
O0001
(rule: F 5.4 G87 without Q: in one feed; U is a distance from R)
(expect: path X60Z-10 X50 x30f0.1 X60 X70)
G99G97S500M03
T0101
G00X60.Z-10.
G87U-20.R-5.F0.1
G80
X70.
M30
%
