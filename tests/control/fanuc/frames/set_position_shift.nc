%
O0001
(rule: F 3.4 G92 takes G52 of its axis back)
(expect: #1=5)
G52X10.
G92X0
X5.
#1=#5021
M30
%
