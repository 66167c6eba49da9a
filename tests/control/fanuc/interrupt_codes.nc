%
O0001
(rule: F 2.4 M96 belongs to the control)
(expect: alarm  K5018 at 5:1)
M96P2
M30
%
