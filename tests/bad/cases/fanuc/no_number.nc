%
O0001
G00 X Y1.
M30
%
(expect: 3:5 PS0005 NO DATA AFTER ADDRESS: there is no number behind `X`)
(exit: 3)
