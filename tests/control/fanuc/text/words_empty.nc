%
O0001
(rule: F 1.3 an empty block is legal)
(expect: to X1)
(expect: to X2)
G00X1.

N5
;
X2.
M30
%
