%
O0001
G02 X10. Y0. CR=7. F100.
M30
%
(expect: 3:14 PS0005 NO DATA AFTER ADDRESS: there is no number behind `C`)
(exit: 3)
