%
O00001
(rule: Haas G103: limits the look-ahead, moves nothing)
(expect: to X1)
(expect: to X2)
G103 P1
G00 X1.
G103
G187 P3 E0.05
X2.
M30
%
