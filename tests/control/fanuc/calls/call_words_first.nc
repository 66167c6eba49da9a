%
O0001
(rule: F 6.8 other words of the block are executed first)
(expect: to X5)
(expect: to X1)
G00X5.M98P2
M30
O0002
X1.
M99
%
