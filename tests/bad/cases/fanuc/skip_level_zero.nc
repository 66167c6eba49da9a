%
O0001
/0 G00 X5.
M30
%
(expect: 3:1 K5020 there is no skip level `0`)
(exit: 3)
