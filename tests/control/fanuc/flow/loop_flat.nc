%
O0001
(rule: F 6.7 plain blocks run again)
(expect: to X1 Y2)
(expect: to X2 Y2)
(expect: to X3 Y4)
(expect: to X4 Y4)
(expect: to X5 Y6)
(expect: to X6 Y6)
#1=0
S1000M03F100.
G91
WHILE[#1LT3]DO1
G01X1.Y2.
X1.
#1=#1+1
END1
M30
%
