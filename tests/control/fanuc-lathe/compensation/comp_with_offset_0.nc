%
O0001
(rule: case 6: the nose of offset 0 has no radius, and T0100 calls none)
(machine: lathe)
(expect: warning K5901 at 8:3)
T0100
G97S500M3G0X50.Z2.
G1G42X40.Z0F0.2
Z-20.
G40X50.Z5.
M30
%
