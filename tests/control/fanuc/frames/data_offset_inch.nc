%
O0001
(rule: F 6.5 under G20 offsets are inches)
(expect: to X25.4)
(expect: #1=1)
G20
G10L2P1X1.
G54G00X0.
#1=#5221
M30
%
