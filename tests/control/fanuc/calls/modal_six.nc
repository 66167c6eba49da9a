%
O0001
(rule: F 6.8 at most 5 modal calls)
(expect: alarm PS0122 K5468 at 10:1)
G66P2
G66P2
G66P2
G66P2
G66P2
G66P2
M30
O0002
M99
%
