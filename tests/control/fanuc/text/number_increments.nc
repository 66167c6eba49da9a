%
O0001
(rule: F 1.6 PS0003: more than nine digits in increments)
(expect: alarm PS0003 K5004 at 5:1)
X1234567.
M30
%
