%
O0001
(rule: technologist, wrong motion: under G95 F counts for a turn, and no edge cuts 150 mm)
(expect: warning K5970 at 9:8)
T1M6
S1000M3
G43H1G0Z5.
G95
G1Z-20.F150.
Z5.
M30
%
