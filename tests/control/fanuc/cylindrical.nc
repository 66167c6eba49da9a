%
O0001
(rule: F 3.6 G07.1)
(expect: alarm  K5018 at 5:1)
G07.1C20.
M30
%
