%
O0001
G43 H500 Z50.
M30
%
(expect: 3:5 PS0030 ILLEGAL OFFSET NUMBER: `H500` names a tool offset that the control does not have)
(exit: 3)
