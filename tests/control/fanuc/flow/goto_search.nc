%
O0001
(rule: F 6.7 forward first, then from the head)
(expect: #1=11)
#1=0
N10 #1=#1+1
IF[#1GE2]GOTO99
GOTO10
N10 #1=#1+10
GOTO99
#1=100
N99
M30
%
