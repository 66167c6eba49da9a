%
O0001
(rule: F 12 a literal is cut off)
(expect: to X1.234)
G00X1.23456
M30
%
