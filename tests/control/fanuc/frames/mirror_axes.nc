%
O0001
(rule: F 3.7 G51.1 per axis about its place; G50.1 per axis)
(expect: to X20 Y-5)
(expect: to X0 Y-5)
G51.1X10.
G51.1Y0
X0Y5.
G50.1X0
X0Y5.
M30
%
