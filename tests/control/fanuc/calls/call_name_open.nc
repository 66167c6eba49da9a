%
O0001
(rule: F 11 PS0311: a name without its end)
(expect: alarm PS0076 K5463 at 5:4)
M98<NOPE
M30
%
