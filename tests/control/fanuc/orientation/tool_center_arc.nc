%
O0001
(rule: F 4.7 G02 under G43.4: the tip is on the arc)
(machine: five-axis)
(expect: to X0)
(expect: to X0 Y0 Z0 A20 C0)
(expect: to X10 Y0 Z0 A30 cw I5 J0)
T1M06
S1000M03
G43.4H1
G01X0Y0Z0A20.F500.
G02X10.Y0I5.A30.
M30
%
