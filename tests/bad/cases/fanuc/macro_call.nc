%
O0001
G65 P9100 A1.
M30
%
(expect: 3:1 K5018 `G65` (macro call) is not supported by Kadr yet)
(exit: 3)
