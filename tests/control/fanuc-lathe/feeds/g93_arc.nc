%
O0001
(rule: F 2.5, 3.2 G93 on a lathe: F of an arc is feed by radius, X a diameter)
(expect: to X10 Z0)
(expect: to X12 Z-2 line F600)
(expect: to X10 Z-4 ccw F600.0000025)
S500M03
G00X20.Z0
G93G01X24.Z-2.F600.
G03X20.Z-4.I-2.K0F942.4778
M30
%
