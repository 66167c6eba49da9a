%
O0001
(rule: F 11 PS1091 two calls in one block)
(expect: alarm PS1091 K5464 at 5:6)
M98P2M98P3
M30
%
