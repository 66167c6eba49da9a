%
O0001
G65 P9100 A1.
M30
%
(expect: 3:5 PS0076 PROGRAM NOT FOUND: there is no program `O9100`)
(exit: 3)
