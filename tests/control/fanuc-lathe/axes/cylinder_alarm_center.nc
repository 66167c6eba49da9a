%
O0001
(rule: F 3.6 G07.1: arcs by R, not by I J K)
(machine: driven)
(expect: alarm PS0176 K5543 at 9:19)
G98 G97 S1000 M3
G00 X40. C0 Z0
G07.1 C20.
G02 Z-10. C28.648 K-10. F100
M30
%
