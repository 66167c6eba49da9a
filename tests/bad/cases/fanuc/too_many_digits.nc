%
O0001
G00 X1234567.
M30
%
(expect: 3:5 PS0003 TOO MANY DIGIT: `X1234567.` has too many digits)
(exit: 3)
