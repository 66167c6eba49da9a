%
O0001
(rule: F 1.3 N0 is not allowed)
(expect: alarm  K5021 at 5:1)
N0G00X1.
M30
%
