%
O0001
(rule: F 4.7 G43.5 P1: the vector goes along a great circle)
(machine: five-axis)
(expect: to X0)
(expect: to X10 A45 C90 cone O0.707107,0,0.707107)
T1M06
S1000M03
G43.5H1P1
G01X10.I1.K1.F500.
M30
%
