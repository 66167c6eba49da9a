%
O0001
(rule: F 1.1 lower case is no program text: only inside comments)
(expect: alarm PS0004 K5015 at 6:1)
(lower case)
g00X1.
M30
%
