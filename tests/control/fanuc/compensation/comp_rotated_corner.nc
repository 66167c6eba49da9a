%
O0001
(rule: F 4.3 a square corner stays one under G68)
(expect: to X20 Y0)
(expect: to X0 Y-5)
(expect: to X-35 Y-5)
(expect: to X-35 Y30)
(expect: to X-30 Y50)
G10L12P1R5.
G68X0Y0R90.
G00X0Y-20.S500M3
G41D1G01X0Y0F100
Y30.
X30.
G40X50.
G69
M30
%
