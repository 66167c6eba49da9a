%
O0001
(rule: F 3.2 an M code beside G04)
(expect: to X10)
G04U2.M8
G00X20.
M30
%
