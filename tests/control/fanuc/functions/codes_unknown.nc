%
O0001
(rule: F 2.2 an unknown G code: PS0010)
(expect: alarm PS0010 K5002 at 5:1)
G999
M30
%
