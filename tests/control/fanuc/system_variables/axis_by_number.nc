%
O0001
(rule: F 6.6 AX[n] is the address of an axis, AXNUM[X] its number)
(expect: #1=3)
(expect: path X10 Y5Z-2)
#1=AXNUM[Z]
G00AX[1]=10.
AX[2]=5.AX[#1]=-2.
M30
%
