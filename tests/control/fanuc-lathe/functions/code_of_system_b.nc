%
O0001
(rule: F 2.4 G90 alone in system A is a cycle and no dimensions: its alarm says so, foreign.txt how)
(machine: lathe)
(expect: fix in G-code system A `G90` is the cycle that turns along Z, and U and W are distances; in system B it is absolute dimensions: `-d fanuc-lathe-b`)
(expect: alarm PS0011 K5210 at 7:1)
G90
M30
%
