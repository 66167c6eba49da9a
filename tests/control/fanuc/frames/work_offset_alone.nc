%
O0001
(rule: F 12 G54.1 without P is G54.1 P1)
(expect: #1=1)
G54.1
#1=#4130
M30
%
