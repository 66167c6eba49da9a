%
O0001
(rule: F 6.3 a bracketed vacant)
(expect: to X5 Y5)
(expect: to X5 Y1)
G00X5.Y5.
X[#1]Y1.
M30
%
