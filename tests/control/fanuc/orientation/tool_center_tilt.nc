%
O0001
(rule: F 4.7 PS5421: G68.2 is chosen in front of G43.4, not inside of it)
(machine: five-axis)
(expect: alarm PS5421 K5611 at 9:1)
G21G90G94G40G49G80
S1000M03
G43.4H1
G68.2X0Y0Z0I0J30.K0
M30
%
