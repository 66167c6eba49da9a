%
O0001
(rule: F 4.8 G53.1: the rotary axes hold the tool along Z of the plane, A = +30 where a positive A turns the tool by the right hand; the table turns the place X10 Y0 Z0 about X0 Y2 Z-50)
(machine: five-axis)
(expect: to X0 Y0 Z0 A0)
(expect: to X0 Y0 Z0 A30 C0)
(expect: to X10 Y25.267949 Z-5.69873 A30)
T1M06
S1000M03
G54
G00X0Y0Z0
G68.2X0Y0Z0I0J30.K0
G53.1
G01X10.Y0Z0F500.
G69
M30
%
