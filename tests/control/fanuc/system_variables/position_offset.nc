%
O0001
(rule: F 6.5 work and machine coordinates)
(expect: #1=1)
(expect: #2=11)
(expect: #3=1)
(expect: #4=55)
G55
G00X1.Y2.Z3.
#1=#5001
#2=#5021
#3=#5041
#4=#4014
M30
%
