%
O0001
(NO END
G00 X0.
M30
%
(expect: 3:1 PS0004 INVALID BREAK POINT OF WORDS: the comment is not closed)
(exit: 3)
