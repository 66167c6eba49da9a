%
O0001
(rule: F 1.3 an M code beside G92)
(expect: to X5)
(expect: to X7)
G00X5.
G92X0Y0Z0M8
X2.
M30
%
