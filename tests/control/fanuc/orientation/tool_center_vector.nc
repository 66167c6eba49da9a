%
O0001
(rule: F 4.7 G43.5: I J K is the vector from tip to holder, of any length; none: it stays, some: the others are 0; the axes go evenly)
(machine: five-axis)
(expect: to X0)
(expect: to X10 A45 C90 axes O0.707107,0,0.707107)
(expect: to X20 A45 C90 axes)
(expect: to X30 A0 axes O0,0,1)
T1M06
S1000M03
G43.5H1
G01X10.I1.K1.F500.
X20.
X30.K5.
M30
%
