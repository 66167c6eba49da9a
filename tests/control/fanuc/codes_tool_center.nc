%
O0001
(rule: F 2.2 G43.4 is an option that Kadr does not execute)
(expect: alarm  K5018 at 5:1)
G43.4H1
M30
%
