%
O0001
(rule: F 3.4 an offset that a macro writes stays written)
(expect: to X33)
G65P9300X33.
G54G00X0.
M30
%
O9300
G10L2P1X#24
M99
%
