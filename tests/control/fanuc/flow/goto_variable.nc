%
O0001
(rule: F 6.7 GOTO#1, GOTO[expression])
(expect: #2 vacant)
(expect: #3 vacant)
(expect: #4=1)
#1=20
GOTO#1
#2=1
N20 GOTO[#1+10]
#3=1
N30 #4=1
M30
%
