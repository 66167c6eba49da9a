%
O0001G20
(rule: F 1.2 blanks count nowhere: words may begin right behind the number of a program)
(expect: to X50.8 Z25.4)
G00X4.Z1.
M30
%
