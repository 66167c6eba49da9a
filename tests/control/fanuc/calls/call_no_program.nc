%
O0001
(rule: F 6.8 M98 without P)
(expect: alarm PS0076 K5463 at 5:1)
M98L2
M30
%
