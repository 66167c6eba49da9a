%
O0001
(rule: technologist, wrong motion: G43 H3 with tool 2 in the spindle is the length of tool 3)
(expect: warning K5973 at 8:1)
T2M6
S1000M3
G0X0Y0
G43H3Z10.
G1Z-1.F100.
M30
%
