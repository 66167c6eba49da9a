%
O0001
(rule: F 4.3 the third axis moves as it is programmed)
(expect: to X0 Y0 Z5)
(expect: to X-5 Y20 Z0)
(expect: to X-5 Y45 Z-2)
(expect: to X-50 Y45 Z-2)
(expect: to X-50 Y0 Z-2)
M3S1000
G10L12P1R5.
G00X0Y0Z5.
G01G41D1X0Y20.Z0F100
Y50.Z-2.
X-50.
G40X-50.Y0
M30
%
