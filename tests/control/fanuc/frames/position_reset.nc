%
O0001
(rule: F 3.4 G92.1: what G92 and G52 have done is taken back)
(expect: to X10)
(expect: to X20)
(expect: to X5)
G00X10.
G92X0
X10.
G92.1X0
X5.
M30
%
