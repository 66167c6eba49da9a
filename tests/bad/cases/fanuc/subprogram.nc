%
O0001
M98 P1000
M30
%
(expect: 3:1 PS0010 IMPROPER G-CODE: `M98` has no meaning on this control)
(exit: 3)
