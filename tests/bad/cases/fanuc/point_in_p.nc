%
O0001
G04 P1.5
M30
%
(expect: 3:5 PS0007 ILLEGAL USE OF DECIMAL POINT: `P1.5` must be a whole number without a decimal point)
(exit: 3)
