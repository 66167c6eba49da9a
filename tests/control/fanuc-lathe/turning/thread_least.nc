%
O0001
(rule: F 11 PS0316: the least cut of G76 is more than the thread's height)
(expect: alarm PS0316 K5253 at 8:1)
G99 G97 S500 M03
G00 X30. Z2.
G76 P020060 Q2000 R0.05
G76 X18. Z-30. P1000 Q500 F2.
M30
%
