%
O0001
(rule: F 4.2 G43.1 is a tool length along the tool of old machines, which Kadr does not execute)
(expect: alarm  K5018 at 5:1)
G43.1H1
M30
%
