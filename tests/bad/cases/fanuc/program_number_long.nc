%
O123456789
G00 X0. Y0.
M30
%
(expect: 2:1 PS0074 ILLEGAL PROGRAM NUMBER: `O123456789` is no number of a program)
(exit: 3)
