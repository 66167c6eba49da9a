%
O0001
(rule: F 6.2 an option: PS0115)
(expect: alarm PS0115 K5410 at 5:4)
#1=#200
M30
%
