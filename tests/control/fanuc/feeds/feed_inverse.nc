%
O0001
(rule: F 3.2 G93: a line F = feed by length, an arc feed by radius)
(expect: to X10 F20)
(expect: to X20 cw)
M3S1000
G93G01X10.F20.
G02X20.I5.F20.
M30
%
