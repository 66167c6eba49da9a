%
O0001
(rule: F 1.1 PS5010: % before M30)
(expect: alarm PS5010 K5261 at 7:1)
(expect: to X1)
G00X1.
%
