%
O0001
(rule: F 3.4 G10 L2 Pp writes a work offset, under G90 in place of what it has; the blocks behind use it)
(expect: to X1)
(expect: to X101 Y5)
(expect: #1=100)
(expect: #2=5)
G90G54G00X1.
G10L2P1X100.Y5.
X1.Y0.
#1=#5221
#2=#5222
M30
%
