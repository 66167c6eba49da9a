%
O0001
(rule: F 2.3 No.3401#0 DPI = 1 on a lathe: diameters and distances in millimetres)
(machine: lathe)
(expect: path X50Z2 x40z-10f0.2 x42)
T0101
G97S500M03
G00X50Z2
G01X40Z-10F0.2
U2
M30
%
