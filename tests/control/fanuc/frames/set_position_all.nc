%
O0001
(rule: F 3.4, 12 G92 shifts all work systems)
(expect: to X10)
(expect: to X25)
(expect: to X26)
(expect: to X35)
G55X0
G54X25.
G92X0
X1.
G55X0
M30
%
