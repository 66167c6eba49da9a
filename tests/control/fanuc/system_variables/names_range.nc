%
O0001
(rule: F 6.6 SETVN names #500 to #549)
(expect: alarm PS0115 K5582 at 5:1)
SETVN 549[LAST,BEHIND]
M30
%
