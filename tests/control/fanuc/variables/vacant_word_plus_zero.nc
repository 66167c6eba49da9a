%
O0001
(rule: F 6.3 X[#1+0] is X0)
(expect: to X5 Y5)
(expect: to X0 Y2)
G00 X5. Y5.
X[#1+0] Y2.
M30
%
