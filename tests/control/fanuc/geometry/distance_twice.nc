%
O0001
(rule: F 3.1 G90 and G91 in one block: the last one for all of it)
(expect: to X10 Y10)
(expect: to X15 Y15)
(expect: to X1 Y15)
X10.Y10.
G90G91X5.Y5.
G91G90X1.
M30
%
