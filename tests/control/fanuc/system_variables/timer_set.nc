%
O0001
(rule: F 6.5 #3001 can be written)
(expect: #1=250)
G04P500
#3001=0
G04P250
#1=#3001
M30
%
