%
O0001
(rule: F 4.7 PS5421: G53 inside of G43.4)
(machine: five-axis)
(expect: alarm PS5421 K5609 at 9:1)
T1M06
S1000M03
G43.4H1
G53Z0
M30
%
