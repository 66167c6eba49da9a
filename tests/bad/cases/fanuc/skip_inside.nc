%
O0001
G0 X5. /Y1.
M30
%
(expect: 3:8 K5018 a part of a block that the operator may leave out is not supported by Kadr yet)
(exit: 3)
