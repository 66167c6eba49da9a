%
O0001
(rule: F 11 PS5457: one of three coordinates of the origin)
(expect: alarm PS5457 K5652 at 5:1)
G68.2X1.J30.
M30
%
