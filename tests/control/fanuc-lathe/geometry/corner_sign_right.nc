%
O0001
(rule: F 3.5 R-2. and ,R2. both go on towards Z-)
(machine: lathe)
(expect: path X100Z2 x54f0.1 cw:x50z0 z-20 x76 ccw:x80z-22 z-30)
T0101
G99G97S500M03F0.1
G00X100.Z2.
G01X50.R-2.
Z-20.
X80.,R2.
Z-30.
M30
%
