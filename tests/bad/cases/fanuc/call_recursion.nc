%
O0001
M98 P2
M30
O0002
M98 P2
M99
%
(expect: 6:1 PS0077 TOO MANY SUB,MACRO NESTING: more than 10 programs inside each other)
(exit: 3)
