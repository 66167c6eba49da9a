%
O0001
(rule: F 12 7 MOD 4 + 1, -7 MOD 4, 2*3/4*2)
(expect: #1=4)
(expect: #2=-3)
(expect: #3=3)
(expect: #4=9)
#1=7MOD4+1
#2=-7MOD4
#3=2*3/4*2
#4=12AND10OR1
M30
%
