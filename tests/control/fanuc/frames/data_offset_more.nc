%
O0001
(rule: F 3.4 G10 L20 Pp: the additional offsets)
(expect: to X7 Z-2)
(expect: to X8 Z0)
G10L20P2X7.Z-2.
G54.1P2G00X0.Z0.
G10L20P48X8.
G54.1P48X0.Z0.
M30
%
