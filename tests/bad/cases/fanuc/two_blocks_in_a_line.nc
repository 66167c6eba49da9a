%
O0001
G0 X5.; Y1.
M30
%
(expect: 3:9 K5018 a second block in one line is not supported by Kadr yet)
(exit: 3)
