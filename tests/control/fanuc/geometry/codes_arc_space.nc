%
O0001
(rule: F 3.5 G02.4: not executed)
(expect: alarm  K5018 at 5:1)
G02.4X1.Y1.Z1.
M30
%
