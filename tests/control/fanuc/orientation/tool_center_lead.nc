%
O0001
(rule: F 4.7 Q: the vector leans towards the way)
(machine: five-axis)
(expect: to X0)
(expect: to X10 O0.5,0,0.866025)
T1M06
S1000M03
G43.5H1
G01X10.K1.Q30.F500.
M30
%
