%
O0001
(rule: F 4.7 PS5421: a vector without a length)
(machine: five-axis)
(expect: alarm PS5421 K5604 at 9:8)
T1M06
S1000M03
G43.5H1
G01X10.I0J0K0F100.
M30
%
