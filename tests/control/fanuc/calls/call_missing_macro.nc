%
O0001
(rule: F 6.8 a program that is not there)
(expect: alarm PS0076 K5460 at 6:4)
#1=77
G65P#1
M30
%
