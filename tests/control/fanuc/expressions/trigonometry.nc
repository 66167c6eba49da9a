%
O0001
(rule: F 6.4 degrees)
(expect: #1=0.5)
(expect: #2=0.5)
(expect: #3=1)
(expect: #4=0)
(expect: #5=0)
#1=SIN[30]
#2=COS[60]
#3=TAN[45]
#4=SIN[180]
#5=COS[90]
M30
%
