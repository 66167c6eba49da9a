%
O0001
(rule: F 6.7 GOTO n)
(expect: #1=1)
(expect: #2=3)
#1=1
GOTO20
#1=2
N20 #2=3
M30
%
