%
O0001
G41 D1
M30
%
(expect: 3:1 K5250 cutter radius compensation is not executed yet)
(exit: 3)
