%
O0001
(rule: F 11 PS5458: no plane before G53.1)
(expect: alarm PS5458 K5653 at 5:1)
G53.1
M30
%
