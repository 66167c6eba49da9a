%
O0001
(rule: F 8.4 a vacant value is none: R is missing, and L11 is right)
(expect: alarm PS1144 K5283 at 5:1)
G10 L11 P1 R#1
M30
%
