%
O0001
G02 X10. Y0. CR=7. F100.
M30
%
(expect: 3:14 PS0009 IMPROPER NC-ADDRESS: `CR` is not a word of this control)
(exit: 3)
