%
O0001
(rule: F 3.5 G18: K and I; G19: J and K)
(expect: to X10 Z10 cw I0 K10)
(expect: to Y10 Z0 ccw)
G18G02X10.Z10.I0K10.F100
G19G03Y10.Z0J0K-10.
M30
%
