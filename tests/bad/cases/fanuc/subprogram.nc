%
O0001
M98 P1000
M30
%
(expect: 3:1 K5018 `M98` (subprogram) is not supported by Kadr yet)
(exit: 3)
