%
O0001
(rule: F 12 FIX FUP ROUND)
(expect: #1=-1)
(expect: #2=-2)
(expect: #3=-2)
(expect: #4=3)
(expect: #5=2)
(expect: #6=1)
(expect: #7=2)
#1=FIX[-1.7]
#2=FUP[-1.2]
#3=ROUND[-1.5]
#4=ROUND[2.5]
#5=FUP[1.2]
#6=FIX[1.9]
#7=FUP[2]
M30
%
