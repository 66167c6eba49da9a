%
O0001
(rule: F 3.6 G12.1)
(expect: alarm  K5018 at 5:1)
G12.1
M30
%
