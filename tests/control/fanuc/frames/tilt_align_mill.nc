%
O0001
(rule: F 11 PS5459: the parameters name no rotary axes)
(expect: alarm PS5459 K5650 at 6:1)
G68.2J30.
G53.1
M30
%
