%
O0001
G00 ?1.
M30
%
(expect: 3:5 PS0004 INVALID BREAK POINT OF WORDS: `?` cannot be read here)
(exit: 3)
