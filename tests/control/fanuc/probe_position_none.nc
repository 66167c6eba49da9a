%
O0001
(rule: F 6.5 before any G31 there is no such position)
(expect: alarm PS0115 K5410 at 5:4)
#1=#5061
M30
%
