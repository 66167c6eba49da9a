%
O0001
(rule: F 4.7 PS5421: G02 under G43.5)
(machine: five-axis)
(expect: alarm PS5421 K5612 at 9:1)
T1M06
S1000M03
G43.5H1
G02X10.Y0R5.F100.
M30
%
