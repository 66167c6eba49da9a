%
O0001
(rule: F 11 PS5456)
(expect: alarm PS5456 K5651 at 6:1)
G68.2J30.
G68.2J20.
M30
%
