%
O0001
g00 x0.
M30
%
(expect: 3:1 PS0004 INVALID BREAK POINT OF WORDS: `g` cannot be read here)
(exit: 3)
