%
O0001
(rule: F 6.5 #3901, #3902: parts made and required)
(expect: #1=0)
(expect: #2=1)
(expect: #3902=20)
#1=#3901
#3901=#3901+1
#2=#3901
#3902=20
M30
%
