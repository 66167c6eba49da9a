%
O0001
(rule: F 6.2 no such number: PS0115)
(expect: alarm PS0115 K5410 at 5:1)
#34=1
M30
%
