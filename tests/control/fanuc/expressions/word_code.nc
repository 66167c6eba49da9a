%
O0001
(rule: F 6.4 G#1 and M[3.5])
(expect: to X5)
(expect: to X10)
#1=1
#2=91
S1000 M[2.6]
G#1X5.F100.
G#2X5.
M30
%
