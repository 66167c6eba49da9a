%
O0001
(rule: F 6.5 #5201+20k+n-1: work offsets)
(expect: #1=0)
(expect: #2=10)
(expect: #3=20)
(expect: #4=30)
#1=#5221
#2=#5241
#3=#5242
#4=#5243
M30
%
