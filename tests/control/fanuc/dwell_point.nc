%
O0001
(rule: F 3.2 P takes no point: PS0007)
(expect: alarm PS0007 K5005 at 5:4)
G04P1.5
M30
%
