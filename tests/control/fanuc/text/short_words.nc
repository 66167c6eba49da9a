%
O0001
(rule: F 6.1 two letters of a keyword or function are enough)
(expect: #1=3)
(expect: #2=3)
(expect: #3=4)
(expect: #4=1)
(expect: #5 vacant)
#1=0
WH[#1LT3]DO1
#1=#1+1
EN1
#2=RO[2.5]
#3=SQ[16]
#4=FI[1.7]
IF[#1EQ3]GO10
#5=1
N10
M30
%
