%
O0001
(rule: F 4.8 G69 before G52)
(expect: alarm  K5234 at 6:1)
G68.2J30.
G52X1.
M30
%
