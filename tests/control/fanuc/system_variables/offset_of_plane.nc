%
O0001
(rule: F 11 PS0028: a parallel axis beside its basic one)
(expect: alarm PS0009 K5230 at 5:4)
G17U1.Y0
M30
%
