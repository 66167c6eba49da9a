%
O0001
(rule: F 12 precedence)
(expect: #1=14)
(expect: #2=20)
(expect: #3=9)
(expect: #4=4)
(expect: #5=-3)
(expect: #6=3)
(expect: #7=5)
(expect: #8=-6)
#1=2+3*4
#2=[2+3]*4
#3=12AND10OR1
#4=7MOD4+1
#5=-7MOD4
#6=2*3/4*2
#7=10-2-3
#8=-2*3
M30
%
