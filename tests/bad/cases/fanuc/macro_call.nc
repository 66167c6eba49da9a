%
O0001
G65 P9100 A1.
M30
%
(expect: 3:1 PS0010 IMPROPER G-CODE: `G65` has no meaning on this control)
(exit: 3)
