%
O0001
G00 X0. ; COMMENT
M30
%
(expect: 3:9 PS0004 INVALID BREAK POINT OF WORDS: `;` cannot be read here)
(exit: 3)
