%
O0001
(rule: F 6.7 the pattern of if and else)
(expect: #2=0)
#1=-4
IF[#1LE0]GOTO10
#2=SQRT[#1]
GOTO11
N10#2=0
N11
M30
%
