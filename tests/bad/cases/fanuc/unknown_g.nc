%
O0001
G999
M30
%
(expect: 3:1 PS0010 IMPROPER G-CODE: `G999` has no meaning on this control)
(exit: 3)
