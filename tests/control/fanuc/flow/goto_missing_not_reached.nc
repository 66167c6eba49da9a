%
O0001
(rule: F 6.7 a jump that is not executed is not searched)
(expect: #2=1)
#1=1
IF[#1EQ2]GOTO55
#2=1
M30
%
