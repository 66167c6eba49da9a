%
O0001
M98 P1000
M30
%
(expect: 3:5 PS0076 PROGRAM NOT FOUND: there is no program `O1000`)
(exit: 3)
