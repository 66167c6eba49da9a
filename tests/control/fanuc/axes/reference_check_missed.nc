%
O0001
(rule: F 3.3 G27: it is not: PS0092)
(expect: to X10)
(expect: alarm PS0092 K5343 at 6:1)
G27X10.
M30
%
