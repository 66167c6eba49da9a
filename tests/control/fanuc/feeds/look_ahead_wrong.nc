%
O0001
(rule: F 3.2 PS0109: P of G08 is 0 or 1)
(expect: alarm PS0109 K5012 at 5:4)
G08P2
M30
%
