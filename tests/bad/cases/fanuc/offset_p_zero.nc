%
O0001
G54 P0
G00 X0.
M30
%
(expect: 3:5 PS0030 ILLEGAL OFFSET NUMBER: there is no work offset G54 P0)
(exit: 3)
