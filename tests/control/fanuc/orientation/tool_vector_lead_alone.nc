%
O0001
(rule: F 4.7 Q leans the direction that I, J and K of the block say)
(machine: five-axis)
(expect: alarm PS5421 K5842 at 9:8)
G21G90G94G40G49G80
S1000M03
G43.5H1
G01X10.Q20.F500
M30
%
