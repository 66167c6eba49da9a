%
O0001
(rule: F 12 G04P500, G04X0.5, G04X500: each half a second)
(expect: #1=500)
(expect: #2=1000)
(expect: #3=1500)
#3001=0
G04P500
#1=#3001
G04X0.5
#2=#3001
G04X500
#3=#3001
M30
%
