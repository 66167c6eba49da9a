%
O0001
(rule: F 3.6 G32 Q: start angle)
(expect: path X20Z5 t2@180:z-15)
G97S500M03
G00X20.Z5.
G32W-20.F2.Q180000
M30
%
