%
O0001
(rule: F 6.7 backward jumps)
(expect: #1=5)
#1=0
N10 #1=#1+1
IF[#1LT5]GOTO10
M30
%
