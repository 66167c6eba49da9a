%
O0001
(rule: F 4.8 G68.4: a plane in the plane that acts)
(expect: to X10 Y-4 Z8.4641)
G68.2X0Y0Z0I0J30.K0
G68.4X0Y0Z4.I0J60.K0
G00X10.Y5.Z2.
M30
%
