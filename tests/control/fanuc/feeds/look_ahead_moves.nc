%
O0001
(rule: F 3.2 G05.1, G05 and G08 stand in a block of their own)
(expect: alarm PS0010 K5013 at 7:1)
(expect: to X5)
G00X5.
G08P1X0
M30
%
