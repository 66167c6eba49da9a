%
O0001
(rule: F 4.7 PS5421: a cycle inside of G43.4)
(machine: five-axis)
(expect: alarm PS5421 K5611 at 9:1)
T1M06
S1000M03
G43.4H1
G81X10.Z-5.R2.F100.
M30
%
