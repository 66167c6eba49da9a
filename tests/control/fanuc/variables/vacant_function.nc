%
O0001
(rule: F 6.3 as an argument vacant is 0)
(expect: #2=0)
(expect: #3=0)
(expect: #4=1)
#2=ABS[#1]
#3=SIN[#1]
#4=COS[#1]
M30
%
