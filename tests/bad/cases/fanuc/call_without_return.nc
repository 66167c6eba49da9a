%
O0001
T1 M6
S1000 M3
M98 P2
M30
O0002
G00 X10.
%
(expect: 9:1 PS5010 END OF RECORD: the program ends without a return)
(exit: 3)
