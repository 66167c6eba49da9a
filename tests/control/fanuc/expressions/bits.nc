%
O0001
(rule: F 6.4 AND OR XOR of whole numbers)
(expect: #1=8)
(expect: #2=15)
(expect: #3=6)
(expect: #4=8)
(expect: #5=255)
#1=12AND10
#2=12OR3
#3=12XOR10
#4=12.4AND10.4
#5=-1AND255
M30
%
