%
O0001
(rule: F 6.8 M198 inside of M198)
(expect: alarm PS1080 K5473 at 9:1)
(expect: called 6:1)
M198P2
M30
O0002
M198P12
M99
%
