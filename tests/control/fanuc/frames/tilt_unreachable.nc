%
O0001
(rule: F 4.8 PS5459: the machine does not hold its tool so)
(machine: nutating)
(expect: alarm PS5459 K5654 at 9:1)
T1M06
S1000M03
G68.2X0Y0Z0I0J150.K0
G53.1
M30
%
