%
O0001
M98 P1 M98 P2
M30
%
(expect: 3:8 PS1091 DUPLICATE SUB-CALL WORD: `M98` is a second call in one block)
(exit: 3)
