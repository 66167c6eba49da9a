%
O0001
G54.9 X0.
M30
%
(expect: 3:1 PS0010 IMPROPER G-CODE: `G54.9` has no meaning on this control)
(exit: 3)
