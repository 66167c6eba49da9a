%
O0001
G10 L2 P7 X0.
G00 X0.
M30
%
(expect: 3:8 PS0031 ILLEGAL P COMMAND IN G10: there is no offset G10 P7 that could be written)
(exit: 3)
