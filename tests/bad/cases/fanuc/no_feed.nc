%
O0001
G01 X10.
M30
%
(expect: 3:1 PS0011 FEED ZERO (COMMAND): no feed is set for this line)
(exit: 3)
