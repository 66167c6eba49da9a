%
O0001
(rule: F 3.4 G10 L20: an additional work offset, X a diameter in frames)
(expect: to X9 Z-3)
G10L20P1X-2.Z-5.
S500M03
G54.1P1
G00X20.Z2.
M30
%
