%
O0001
(rule: F 1.5 a comment without its end)
(expect: alarm PS0004 K5019 at 5:7)
G00X1.(ABC
M30
%
