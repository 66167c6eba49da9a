%
O0001
G01 X1. F-100.
M30
%
(expect: 3:9 PS0006 ILLEGAL USE OF MINUS SIGN: `F-100.` may not be negative)
(exit: 3)
