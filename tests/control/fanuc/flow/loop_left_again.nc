%
O0001
(rule: F 6.7 left by a jump, and entered anew)
(expect: #1=3)
(expect: #3=6)
#1=0
#3=0
N5 #2=0
WHILE[1EQ1]DO1
#2=#2+1
#3=#3+1
IF[#2EQ2]GOTO10
END1
N10 #1=#1+1
IF[#1LT3]GOTO5
M30
%
