%
O0001
(rule: F 6.5 #3002: hours, with their fraction)
(expect: #1=0.5)
G04X1800.
#1=#3002
M30
%
