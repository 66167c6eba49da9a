%
O0001
G65 P9001
M30
O9001
G65 P9001
M99
%
(expect: 6:1 PS0122 TOO MANY MACRO NESTING: more than 5 macros inside each other)
(exit: 3)
