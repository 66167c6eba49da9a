%
O0001
(rule: F 6.5 a written work offset acts at once)
(expect: #1=101)
(expect: #2=100)
(expect: to X101)
G54
#5221=100
G00X1.
#1=#5021
#2=#5221
M30
%
