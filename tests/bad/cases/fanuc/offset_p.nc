%
O0001
G54.1 P999
G00 X0.
M30
%
(expect: 3:7 PS0030 ILLEGAL OFFSET NUMBER: there is no work offset G54.1 P999)
(exit: 3)
