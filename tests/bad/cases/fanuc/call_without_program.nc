%
O0001
M98 L2
M30
%
(expect: 3:1 PS0076 PROGRAM NOT FOUND: `M98` does not say which program)
(exit: 3)
