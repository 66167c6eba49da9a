%
O0001
(rule: F 4.7 PS5421: a vector beside places of rotary axes)
(machine: five-axis)
(expect: alarm PS5421 K5603 at 9:8)
T1M06
S1000M03
G43.5H1
G01X10.I1.K1.A5.F100.
M30
%
