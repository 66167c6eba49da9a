%
O0001
(rule: F 6.7 IF THEN one assignment)
(expect: #2=5)
(expect: #3 vacant)
#1=0
IF[#1EQ0]THEN#2=5
IF[#1EQ1]THEN#3=5
M30
%
