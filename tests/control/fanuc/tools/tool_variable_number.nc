%
O0001
(rule: F 6.5 there is no offset 0)
(expect: alarm PS0115 K5410 at 5:1)
#11000=1
M30
%
