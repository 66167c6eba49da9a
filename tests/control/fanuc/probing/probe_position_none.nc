%
O0001
(rule: F 6.5 before any G31 nothing was met: 0)
(expect: #1=0)
#1=#5061
M30
%
