%
O0001
(rule: F 6.8 P is a whole number)
(expect: alarm PS0076 K5463 at 5:4)
M98P1.5
M30
%
