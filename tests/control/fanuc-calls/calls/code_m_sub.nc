%
O0001
(rule: F 6.8 No.6071: an M code calls O9001 as M98 does)
(expect: #1=3)
(expect: #100=2)
#1=2
M61
M30
O9001
#100=#1
#1=3
M99
%
