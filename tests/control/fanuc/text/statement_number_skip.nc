%
O0001
(rule: F 6.1 N and /n may stand in front of a macro statement)
(skip: 2)
(expect: #1=1)
N10 #1=1
/2 N20 #1=2
M30
%
