%
O00001
(rule: Haas G04: seconds with a point, milliseconds without one)
(expect: to X1)
(expect: to X2)
G00 X1.
G04 P0.5
G04 P500
X2.
M30
%
