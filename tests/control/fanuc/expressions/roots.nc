%
O0001
(rule: F 6.4 SQRT, ABS, LN, EXP, POW)
(expect: #1=2)
(expect: #2=3.5)
(expect: #3=2)
(expect: #4=1024)
#1=SQRT[2]*SQRT[2]
#2=ABS[-3.5]
#3=LN[EXP[2]]
#4=POW[2,10]
M30
%
