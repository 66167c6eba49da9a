%
O0001
(rule: F 6.4 AND OR between bracketed comparisons)
(expect: #3=1)
(expect: #4 vacant)
#1=1
#2=7
IF[[#1GT0]AND[#2LT5]]GOTO10
#3=1
N10IF[[#1GT0]OR[#2LT5]]GOTO20
#4=1
N20
M30
%
