%
O0001
(rule: F 3.3 G27: the place is the reference point)
(expect: to X5)
(expect: to X0)
G00X5.
G27X0
M30
%
