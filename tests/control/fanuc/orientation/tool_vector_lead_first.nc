%
O0001
(rule: F 4.7 Q beside G43.5: the tool leans so in blocks that say no other Q)
(machine: five-axis)
(expect: to X0)
(expect: to X10 O0.173648,0,0.984808)
(expect: to X20 O0,0,1)
(expect: to X30 O0.173648,0,0.984808)
G21G90G94G40G49G80
S1000M03
G43.5H1Q10.
G01X10.I0J0K1.F500
X20.I0J0K1.Q0
X30.I0J0K1.
M30
%
