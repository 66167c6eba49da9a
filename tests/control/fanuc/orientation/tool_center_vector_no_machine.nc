%
O0001
(rule: F 4.7 the same of vectors)
(expect: alarm PS5420 K5600 at 5:1)
G43.5H1
M30
%
