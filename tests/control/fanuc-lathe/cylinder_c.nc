%
O0001
(rule: F 3.6 G07.1, G107 on a lathe)
(expect: alarm  K5018 at 5:1)
G107C20.
M30
%
