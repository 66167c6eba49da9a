%
O0001
(rule: F 3.6 G32 with a taper: the lead along the longer axis)
(expect: path X20Z5 t2.01:x30z-45)
G97S500M03
G00X20.Z5.
G32X30.Z-45.F2.
M30
%
