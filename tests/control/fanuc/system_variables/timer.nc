%
O0001
(rule: F 6.5 #3001 counts ms of the running program)
(expect: #1=500)
(expect: #2=6500)
G04P500
#1=#3001
G01X10.F100
#2=#3001
M30
%
