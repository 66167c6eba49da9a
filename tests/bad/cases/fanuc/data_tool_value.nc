%
O0001
G10 L10 P1 R1500.
M30
%
(expect: 3:1 PS0032 ILLEGAL OFFSET VALUE IN G10: the tool offset would be 1500, more than the control keeps)
(exit: 3)
