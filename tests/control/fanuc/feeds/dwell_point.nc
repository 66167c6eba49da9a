%
O0001
(rule: F 3.2 P of a dwell takes no point)
(expect: alarm PS0007 K5005 at 5:4)
G04P3.
M30
%
