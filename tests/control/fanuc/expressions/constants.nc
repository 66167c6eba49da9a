%
O0001
(rule: F 6.4 point optional, .5 and 5. legal)
(expect: #1=5.5)
(expect: #2=3)
(expect: #3=0.001)
#1=.5+5.
#2=+3
#3=0.001
M30
%
