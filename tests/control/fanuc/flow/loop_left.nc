%
O0001
(rule: F 6.7 a jump out of a loop)
(expect: #1=3)
(expect: #2=1)
#1=0
DO1
#1=#1+1
IF[#1EQ3]GOTO10
END1
N10 #2=1
M30
%
