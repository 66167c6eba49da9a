%
O0001
(rule: F 11 PS1132)
(expect: alarm PS1132 K5404 at 5:8)
#1=[2+3
M30
%
