%
O0001
(rule: F 3.4 G10 moves nothing, whatever motion is modal)
(expect: to X1)
(expect: to X2)
G01X1.F100
G10L2P3X50.Y50.
X2.
M30
%
