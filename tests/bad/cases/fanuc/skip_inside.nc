%
O0001
#1=4
G0 X#1/2
M30
%
(expect: 4:7 K5018 a part of a block that the operator may leave out is not supported by Kadr yet)
(exit: 3)
