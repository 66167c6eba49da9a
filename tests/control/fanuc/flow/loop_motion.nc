%
O0001
(rule: F 6.7 motions inside a loop)
(expect: to X10 Y1)
(expect: to X20 Y0)
(expect: to X30 Y-1)
(expect: to X0 Y0)
#1=0
S1000M03
WHILE[#1LT3]DO1
#1=#1+1
G01X[#1*10]Y[SIN[#1*90]]F200.
END1
G00X0Y0
M30
%
