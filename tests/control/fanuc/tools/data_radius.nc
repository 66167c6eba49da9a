%
O0001
(rule: F 3.4, 4.1 G10 L12: radius for D)
(expect: to X-10 Y0)
(expect: to X0 Y4)
(expect: to X20 Y4)
(expect: to X30 Y0)
G10L12P5R4.
G00X-10.Y0.
G17G90G01G41D5X0.Y0.F100
X20.
G40X30.
M30
%
