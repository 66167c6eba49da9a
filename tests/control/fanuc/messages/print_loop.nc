%
O0001
(rule: F 6.10 a protocol of positions, in the order of the motions)
(expect: print [N  1 X   10.00])
(expect: print [N  2 X   20.00])
(expect: to X10)
(expect: to X20)
POPEN
#1=1
WHILE[#1LE2]DO1
G00X[10*#1]
DPRNT[N#1[20]*X#5041[42]]
#1=#1+1
END1
PCLOS
M30
%
