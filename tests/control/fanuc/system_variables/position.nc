%
O0001
(rule: F 6.5 #5001 end of the last block, #5041 position)
(expect: #1=10)
(expect: #2=-5)
(expect: #3=3)
(expect: #4=10)
G00X10.Y-5.Z3.
#1=#5001
#2=#5002
#3=#5043
#4=#5021
M30
%
