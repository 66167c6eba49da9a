%
O0001
(rule: F 4.8 G53.1 P1, P2: the sign of the tilting axis)
(machine: five-axis)
(expect: to A30 C0)
(expect: to A-30 C180)
T1M06
S1000M03
G68.2X0Y0Z0I0J30.K0
G53.1P1
G69
G68.2X0Y0Z0I0J30.K0
G53.1P2
G69
M30
%
