%
O0001
G00 X1E3
M30
%
(expect: 3:7 PS0009 IMPROPER NC-ADDRESS: `E3` is not a word of this control)
(exit: 3)
