%
O0001
(rule: F 4.8 G68.3: Z of the plane is the direction of the tool)
(machine: five-axis)
(expect: to A30)
(expect: to X0 Y0 Z0 A30)
(expect: to X0 Y0 Z10 A30)
T1M06
S1000M03
G00A30.
G68.3
G01X0Y0Z0F500.
Z10.
G69
M30
%
