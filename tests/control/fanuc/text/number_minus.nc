%
O0001
(rule: F 1.6 PS0006: no sign in T)
(expect: alarm PS0006 K5006 at 5:1)
T-1
M30
%
