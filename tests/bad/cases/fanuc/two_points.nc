%
O0001
G00 X1.2.3
M30
%
(expect: 3:9 PS0007 ILLEGAL USE OF DECIMAL POINT: `.` cannot be read here)
(exit: 3)
