%
O0001
(rule: F 5.1 a block without X, Y, Z or R drills no hole, also where it names a cycle; its P and Q are not stored)
(expect: path Z50 X10 Z2 z-10f100 Z2 X20 z-10 Z2 X30 z-10 Z2 X40 z-10 Z2)
G90G54G00X0Y0Z50.S1000M03
G99G81X10.Y0Z-10.R2.F100
G82P500
X20.
G83Q4.
X30.
G98G81
G99X40.
G80
M30
%
