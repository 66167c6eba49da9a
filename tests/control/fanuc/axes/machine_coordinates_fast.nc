%
O0001
(rule: F 3.3 G53 P1 is G53)
(expect: to X5)
(expect: to X0)
G54G00X5.
G53P1X0
M30
%
