%
O0001
G00 X1.2.3
M30
%
(expect: 3:6 PS0004 INVALID BREAK POINT OF WORDS: `1` cannot be read here)
(exit: 3)
