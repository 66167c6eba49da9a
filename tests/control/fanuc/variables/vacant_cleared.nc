%
O0001
(rule: F 6.3 a variable is made vacant by #0)
(expect: #1 vacant)
(expect: #2 vacant)
#1=5
#1=#0
IF[#1EQ#0]GOTO10
#2=1
N10
M30
%
