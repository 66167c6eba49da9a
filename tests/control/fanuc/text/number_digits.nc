%
O0001
(rule: F 1.6 nine digits, more than nine: PS0003)
(expect: alarm PS0003 K5004 at 7:1)
(expect: to X1.234)
X1.23456789
X1.234567891
M30
%
