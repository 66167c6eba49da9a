%
O0001
G66 P2
G66 P2
G66 P2
G66 P2
G66 P2
G66 P2
M30
O0002
M99
%
(expect: 8:1 PS0122 TOO MANY MACRO NESTING: more than 5 modal calls inside each other)
(exit: 3)
